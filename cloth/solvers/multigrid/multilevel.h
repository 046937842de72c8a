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
#include "engine/memory/hooked_vector.h"

namespace weft {

class MultilevelSolver final : public Solver {
  public:
    /// `saved`: levels of this model and of the settings' system, or null. Then it is of use to be cloned
    /// alone.
    MultilevelSolver(const ClothModel& model, const ClothSettings& settings, std::span<const Vec4> positions,
                     SavedLevels* saved = nullptr);
    MultilevelSolver(const MultilevelSolver& other, const ClothModel& model);
    [[nodiscard]] std::unique_ptr<Solver> clone(const ClothModel& model) const override {
        return std::make_unique<MultilevelSolver>(*this, model);
    }
    void make_own(const ClothSettings& settings) override { system_->make_own(settings.fabric); }
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

    /// gamma f - M (v - v_base) at the velocities that were solved for, without contact, which gave the
    /// opposite. Valid until the next solve.
    [[nodiscard]] std::span<const Vec4> left_to_contact(const SolverStep& step);

    [[nodiscard]] bool serves(const ClothSettings& settings) const override;
    [[nodiscard]] const Multigrid* multigrid() const noexcept override { return multigrid_.get(); }
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

    /// A component, in the present step.
    struct Piece {
        bool touches = false;                               ///< another, or itself
        bool is_held = false;                               ///< by a pin or a collider
        Eigen::Vector3d missing = Eigen::Vector3d::Zero();  ///< momentum that the solution lacks [kg m/s]
        double inertia = 0;                                 ///< [kg]
    };
    static Vector3 shift_of(const Piece& piece);
    void weigh_pieces(const SolverStep& step);
    void move_free_pieces(const SolverStep& step, const Vector3& of_touching);

    const ClothModel* model_;
    SystemKind kind_;  // by which the system was made
    std::unique_ptr<ImplicitSystem> system_;
    std::unique_ptr<Multigrid> multigrid_;
    CgVectors vectors_;
    AlignedBuffer<double> sums_;  // of blocks
    double rest_area_;            // [m^2]
    StepResidual residual_;
    HookedVector<std::uint32_t> component_of_;  // of particles, only with features
    HookedVector<Piece> pieces_;
};

}  // namespace weft
