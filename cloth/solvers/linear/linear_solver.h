#pragma once
// Linearly implicit steps: linearise once about the base, solve W dv = b.

#include <memory>

#include "cloth/solvers/linear/mean_motion.h"
#include "cloth/solvers/solver.h"
#include "cloth/system/implicit_system.h"

namespace weft {

/// What the solvers of one linear system share; each says how it solves.
class LinearSolver : public Solver {
  public:
    LinearSolver(const CookedCloth& model, const ClothSettings& settings);
    float solve(const SolverStep& step) final;
    [[nodiscard]] std::size_t bytes() const noexcept override;

  protected:
    /// Solves W dv = b into step.velocity_change; see Solver::solve for what it returns.
    virtual float solve_linear(const SolverStep& step, ImplicitSystem& system) = 0;
    /// Whether the method leaves the motion of a whole component so unsolved that it is to be solved apart.
    [[nodiscard]] virtual bool solves_mean_motion_apart(const ClothSettings& /*settings*/) const {
        return false;
    }

  private:
    std::unique_ptr<ImplicitSystem> system_;
    MeanMotion mean_motion_;
};

}  // namespace weft
