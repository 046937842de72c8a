#pragma once
// Makes the solver of a method.

#include <memory>

#include "cloth/solver/solver.h"

namespace weft {

struct SavedLevels;

/// The solver of settings.method, ready for a step. `positions` have inverse masses in w, 0 for pinned
/// particles. The model must outlive it.
[[nodiscard]] std::unique_ptr<Solver> make_solver(const ClothModel& model, const ClothSettings& settings,
                                                  std::span<const Vec4> positions);
/// `saved`: levels of the model and of the settings' system, or null. They are moved from; the solver is then
/// a prototype, only to be cloned.
[[nodiscard]] std::unique_ptr<Solver> make_solver(const ClothModel& model, const ClothSettings& settings,
                                                  std::span<const Vec4> positions, SavedLevels* saved);

}  // namespace weft
