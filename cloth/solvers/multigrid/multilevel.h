#pragma once
// The multilevel method: passes of conjugate gradients that a multigrid cycle preconditions, with a line
// search and more passes where the equation is hard.

#include <memory>

#include "cloth/solvers/linear/conjugate_gradient.h"
#include "cloth/solvers/make_system.h"
#include "cloth/solvers/multigrid/effort.h"
#include "cloth/solvers/multigrid/levels.h"
#include "cloth/solvers/multigrid/multigrid.h"
#include "cloth/solvers/solver.h"
#include "cloth/solvers/step_residual.h"
#include "cloth/system/implicit_system.h"

namespace weft {

class MultilevelSolver final : public Solver {
  public:
    MultilevelSolver(const CookedCloth& model, const ClothSettings& settings,
                     std::span<const Vec4> positions);
    SolveResult solve(const SolverStep& step) override;
    [[nodiscard]] bool serves(const ClothSettings& settings) const override;
    void prepare(const ClothSettings& settings) noexcept override { system_->prepare(settings.fabric); }
    void reserve_pins(std::size_t count) override;
    void inverse_mass_changed(std::uint32_t particle, std::span<const Vec4> positions) noexcept override;
    void inverse_masses_changed(std::span<const Vec4> positions) noexcept override;
    [[nodiscard]] std::size_t bytes() const noexcept override;

  private:
    SolveResult solve_in_passes(const SolverStep& step, const Multilevel& method);
    CgResult take_pass(const SolverStep& step, const Multilevel& method, Effort& effort);
    /// If the last step went too far along `direction`, takes part of it back. `residual` is the equation's
    /// where the step ended.
    bool shorten_last_step(const SolverStep& step, Effort& effort, std::span<const Vec4> residual,
                           std::span<const Vec4> direction, bool a_pass_follows);
    void check_last_step(const SolverStep& step, Effort& effort);
    void linearise(const SolverStep& step);
    void build_levels(const SolverStep& step);
    void cycle(const SolverStep& step, std::span<const Vec4> right_side, std::span<Vec4> x);

    SystemKind kind_;  // by which the system was made
    std::unique_ptr<ImplicitSystem> system_;
    std::unique_ptr<Multigrid> multigrid_;
    CgVectors vectors_;
    AlignedBuffer<double> sums_;  // of blocks
    double rest_area_;            // [m^2]
    StepResidual residual_;
};

}  // namespace weft
