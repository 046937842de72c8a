#pragma once
// Which class each method is.

#include <memory>

#include "cloth/solver/solver.h"

namespace weft {

struct SavedLevels;

/// The solver of settings.method, ready for a step. `positions` have inverse masses in w, 0 for pinned
/// particles. The model must outlive it.
[[nodiscard]] std::unique_ptr<Solver> make_solver(const ClothModel& model, const ClothSettings& settings,
                                                  std::span<const Vec4> positions);
/// `saved`: levels of the model and of the settings' system, or null. They are used up; the solver then is of
/// use to be cloned alone.
[[nodiscard]] std::unique_ptr<Solver> make_solver(const ClothModel& model, const ClothSettings& settings,
                                                  std::span<const Vec4> positions, SavedLevels* saved);

}  // namespace weft
