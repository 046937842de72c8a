#pragma once
// Linearly implicit steps: linearise once about the base, solve W dv = b.

#include <memory>

#include "cloth/equation/implicit_system.h"
#include "cloth/methods/linear/mean_motion.h"
#include "cloth/solver/make_system.h"
#include "cloth/solver/solver.h"
#include "cloth/solver/step_residual.h"

namespace weft {

/// The common part of solvers of one linear system; each solves in solve_linear().
class LinearSolver : public Solver {
  public:
    LinearSolver(const ClothModel& model, const ClothSettings& settings);
    LinearSolver(const LinearSolver& other, const ClothModel& model);
    void make_own(const ClothSettings& settings) override { system_->make_own(settings.fabric); }
    void lay_out(Scratch& scratch, std::size_t pairs) override;
    SolveResult solve(const SolverStep& step) final;
    void prepare(const ClothSettings& settings) noexcept override { system_->prepare(settings.fabric); }
    [[nodiscard]] std::size_t bytes() const noexcept override;

  protected:
    [[nodiscard]] std::uint32_t particles() const noexcept { return mean_motion_.particles(); }
    /// Solves W dv = b; false: no solution was found.
    virtual bool solve_linear(const SolverStep& step, ImplicitSystem& system, std::span<Vec4> dv) = 0;
    /// The part of Solver::serves() that all linear solvers share.
    [[nodiscard]] bool serves_system(const ClothSettings& settings) const {
        return kind_ == SystemKind(settings);
    }
    /// Whether MeanMotion solves the motion of whole components, which few iterations leave almost unsolved.
    [[nodiscard]] virtual bool solves_mean_motion_apart(const ClothSettings& /*settings*/) const {
        return true;
    }

  private:
    SystemKind kind_;
    std::unique_ptr<ImplicitSystem> system_;
    MeanMotion mean_motion_;
    StepResidual residual_;
};

}  // namespace weft
