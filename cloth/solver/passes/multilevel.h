#pragma once
// The multilevel method: passes of Newton's method whose corrections a multigrid cycle finds.

#include <memory>

#include "cloth/equation/implicit_system.h"
#include "cloth/solver/levels/levels.h"
#include "cloth/solver/levels/multigrid.h"
#include "cloth/solver/make_system.h"
#include "cloth/solver/passes/momentum.h"
#include "cloth/solver/passes/passes.h"
#include "cloth/solver/solver.h"
#include "cloth/solver/step_residual.h"

namespace weft {

class MultilevelSolver final : public Solver {
  public:
    /// `saved`: levels of this model and of the settings' system, or null. With levels the solver serves only
    /// to be cloned.
    MultilevelSolver(const ClothModel& model, const ClothSettings& settings, std::span<const Vec4> positions,
                     SavedLevels* saved = nullptr);
    MultilevelSolver(const MultilevelSolver& other, const ClothModel& model);
    [[nodiscard]] std::unique_ptr<Solver> clone(const ClothModel& model) const override {
        return std::make_unique<MultilevelSolver>(*this, model);
    }
    void make_own(const ClothSettings& settings) override { system_->make_own(settings.fabric); }
    void lay_out(Scratch& scratch, std::size_t pairs) override;
    SolveResult solve(const SolverStep& step) override;

    /// The cloth as a member of a group, with the levels that it has in common with what is sewn to it, or
    /// its own. The step must outlive it.
    [[nodiscard]] PassMember member(const SolverStep& step, const CommonLevels& sewn) noexcept;

    /// gamma f - M (v - v_base) at the velocities that were solved for, without contact, which gave the
    /// opposite. Valid until the next solve.
    [[nodiscard]] std::span<const Vec4> left_to_contact(const SolverStep& step);

    [[nodiscard]] bool serves(const ClothSettings& settings) const override;
    [[nodiscard]] const Multigrid* multigrid() const noexcept override { return multigrid_.get(); }
    [[nodiscard]] bool joins() const noexcept override { return true; }
    void reserve_pairs(std::size_t count) override;
    void prepare(const ClothSettings& settings) noexcept override { system_->prepare(settings.fabric); }
    void reserve_pins(std::size_t count) override { multigrid_->reserve_pins(count); }
    void inverse_mass_changed(std::uint32_t particle, std::span<const Vec4> positions) noexcept override;
    void inverse_masses_changed(std::span<const Vec4> positions) noexcept override {
        multigrid_->set_pins(positions);
    }
    [[nodiscard]] std::size_t bytes() const noexcept override;

  private:
    SystemKind kind_;  // the kind that the system was made for
    std::unique_ptr<ImplicitSystem> system_;
    std::unique_ptr<Multigrid> multigrid_;
    PassVectors vectors_;
    FreePieces pieces_;
    double rest_area_;  // [m^2]
    StepResidual residual_;
};

}  // namespace weft
