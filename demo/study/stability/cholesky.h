#pragma once
// Sparse Cholesky factorisation of each step's linear system: exact, and too slow for games.

#include "cloth/methods/linear/linear_solver.h"
#include "demo/study/reference/exact_solve.h"

namespace weft::study {

/// Factorises W = L D L^T in double precision at every step (Eigen's SimplicialLDLT), its pattern analysed
/// once.
class CholeskySolver final : public LinearSolver {
  public:
    CholeskySolver(const ClothModel& model, const ClothSettings& settings);

  protected:
    bool solve_linear(const SolverStep& step, ImplicitSystem& system, std::span<Vec4> dv) override;

  private:
    void fill_matrix(const SolverStep& step, ImplicitSystem& system);

    BlockMatrix matrix_;
    ExactSolve exact_solve_;
};

}  // namespace weft::study
