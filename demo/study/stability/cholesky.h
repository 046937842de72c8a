#pragma once
// Sparse Cholesky factorisation of each step's linear system: exact, and too slow for games.

#include <limits>

#include "cloth/methods/linear/linear_solver.h"
#include "demo/study/reference/exact_solve.h"

namespace weft::study {

/// Factorises W = L D L^T in double precision at every step (Eigen's SimplicialLDLT), its pattern analysed
/// once. With more than `direct_up_to` particles it iterates to 1e-10 instead: reference A1, a step
/// linearised once and solved exactly.
class CholeskySolver final : public LinearSolver {
  public:
    CholeskySolver(const ClothModel& model, const ClothSettings& settings,
                   std::uint32_t direct_up_to = std::numeric_limits<std::uint32_t>::max());

  protected:
    bool solve_linear(const SolverStep& step, ImplicitSystem& system, std::span<Vec4> dv) override;

  private:
    void fill_matrix(const SolverStep& step, ImplicitSystem& system);

    BlockMatrix matrix_;
    ExactSolve exact_solve_;
};

}  // namespace weft::study
