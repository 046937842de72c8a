#pragma once
// Which class each method is.

#include <memory>

#include "cloth/solvers/solver.h"

namespace weft {

/// The solver of settings.method.
[[nodiscard]] std::unique_ptr<Solver> make_solver(const CookedCloth& model, const ClothSettings& settings);

}  // namespace weft
