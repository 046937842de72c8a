#pragma once
// Symplectic Euler, the explicit baseline.

#include <memory>

#include "cloth/solver/make_system.h"
#include "cloth/solver/solver.h"
#include "cloth/solver/step_residual.h"

namespace weft {

/// v += h f(x, v) / m, before x += h v: symplectic where f has no damping (Vogelaere 1956). Stable for h < 2
/// / omega of the stiffest mode, and for less where springs are damped. Drag alone is taken implicitly.
class SymplecticEulerSolver final : public Solver {
  public:
    SymplecticEulerSolver(const ClothModel& model, const ClothSettings& settings);
    void lay_out(Scratch& scratch, std::size_t pairs) override;
    SolveResult solve(const SolverStep& step) override;
    [[nodiscard]] bool serves(const ClothSettings& settings) const override;
    void prepare(const ClothSettings& settings) noexcept override { system_->prepare(settings.fabric); }
    [[nodiscard]] bool is_implicit() const noexcept override { return false; }
    [[nodiscard]] std::size_t bytes() const noexcept override;

  private:
    SystemKind kind_;
    std::unique_ptr<ImplicitSystem> system_;  // for its forces
    StepResidual residual_;
};

}  // namespace weft
