#pragma once
// Solvers that only the study has.

#include "cloth/methods/explicit/symplectic_euler.h"
#include "cloth/methods/linear/linear_solver.h"
#include "demo/study/reference/exact_solve.h"

namespace weft::study {

/// Explicit (forward) Euler: x += h v, v += h f(x, v) / m, both from the state at the step's start. With a
/// mode of frequency omega and damping rate c, x'' = -c x' - omega^2 x, a step has the characteristic
/// equation
///     mu^2 - (2 - h c) mu + 1 - h c + h^2 omega^2 = 0,
/// whose roots are within the unit circle for h <= c / omega^2 if the mode swings (c < 2 omega), and for h <=
/// 4 / (c + sqrt(c^2 - 4 omega^2)) if it creeps. Without damping it gains energy at any step.
///
/// The library's step moves positions by the new velocities. The forces of each step are applied in the next,
/// so that positions move by the old velocities. The cloth's velocities are therefore those of one step ago.
class ExplicitEulerSolver final : public Solver {
  public:
    ExplicitEulerSolver(const ClothModel& model, const ClothSettings& settings);
    SolveResult solve(const SolverStep& step) override;
    [[nodiscard]] bool is_implicit() const noexcept override { return false; }
    [[nodiscard]] std::size_t bytes() const noexcept override;

  private:
    SymplecticEulerSolver forces_;
    AlignedBuffer<Vec4> pending_;            // h f / m of the last step
    AlignedBuffer<Vec4> velocities_, next_;  // at the present positions, and a step later
};

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
