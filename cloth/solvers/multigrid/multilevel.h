#pragma once
// The multilevel method: passes of conjugate gradients that a multigrid cycle preconditions, with a line
// search and more passes where the equation is hard.

#include <memory>
#include <vector>

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

    /// A cloth of an island, and its step.
    struct Member {
        MultilevelSolver* solver;
        const SolverStep* step;
    };
    /// Solves the steps of cloths that touch, as one equation: with equal gamma, pairs and threads. The
    /// effort is that of the first one's settings. Returns what holds for all; each member's residual is
    /// written to `residuals`, if there is one for each.
    static SolveResult solve(std::span<const Member> members, std::span<float> residuals);

    [[nodiscard]] bool serves(const ClothSettings& settings) const override;
    [[nodiscard]] bool joins() const noexcept override { return true; }
    void reserve_pairs(std::size_t count) override;
    void prepare(const ClothSettings& settings) noexcept override { system_->prepare(settings.fabric); }
    void reserve_pins(std::size_t count) override;
    void inverse_mass_changed(std::uint32_t particle, std::span<const Vec4> positions) noexcept override;
    void inverse_masses_changed(std::span<const Vec4> positions) noexcept override;
    [[nodiscard]] std::size_t bytes() const noexcept override;

  private:
    friend class MultilevelSolve;

    void linearise(const SolverStep& step);
    void build_levels(const SolverStep& step);
    void cycle(const SolverStep& step, std::span<const Vec4> right_side, std::span<Vec4> x);

    bool add_missing_momentum(const SolverStep& step, Eigen::Vector3d& missing, double& inertia);
    void move_touching_pieces(const SolverStep& step, const Vector3& shift);

    const CookedCloth* model_;
    SystemKind kind_;  // by which the system was made
    std::unique_ptr<ImplicitSystem> system_;
    std::unique_ptr<Multigrid> multigrid_;
    CgVectors vectors_;
    AlignedBuffer<double> sums_;  // of blocks
    double rest_area_;            // [m^2]
    StepResidual residual_;
    std::vector<std::uint32_t> component_of_;  // of particles, only with features
    std::vector<std::uint8_t> touches_;        // of components, in the present step
};

}  // namespace weft
