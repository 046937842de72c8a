#pragma once
// How far a step's velocities are from solving its equation: one figure with one meaning for every method.

#include <cstdint>
#include <span>

#include "cloth/equation/implicit_system.h"
#include "cloth/equation/step_equation.h"
#include "cloth/mesh/cook.h"
#include "cloth/solver/solver.h"
#include "engine/memory/scratch.h"

namespace weft {

/// |D^-1 r(v)| / max(|D^-1 r(v_free)|, |D^-1 M (v_free - v_base)|), where r(v) = gamma f(x_base + gamma v, v)
/// - M (v - v_base), contacts included, D is the diagonal that each particle has in it, and v_free is where
/// external forces alone lead: 0 where the equation is solved, 1 where fabric and contacts have done nothing.
/// A norm of impulses that are left, against those that fabric and contacts have to give.
///
/// Springs are looked at for one particle in 1024, and at least 4, the same ones in every step, which costs
/// less than a hundredth of one. Finite elements are all looked at, which costs a quarter of a step.
class StepResidual {
  public:
    StepResidual(const ClothModel& model, const ClothSettings& settings)
        : model_(&model), of_elements_(settings.finite_elements.enabled) {}
    /// Of another cloth of that model.
    StepResidual(const StepResidual& other, const ClothModel& model) : StepResidual(other) {
        model_ = &model;
    }
    void lay_out(Scratch& scratch) {
        for (auto* vector : {&free_, &left_})
            scratch.take(*vector, of_elements_ ? model_->particle_count : 0);
    }
    /// `system` is asked for the forces of finite elements only.
    [[nodiscard]] float operator()(Parallel& parallel, const StepEquation& equation,
                                   std::span<const Vec4> velocities, ImplicitSystem* system = nullptr);
    /// Of what a solver has found; 0 where the step wants none.
    [[nodiscard]] float operator()(const SolverStep& step, ImplicitSystem* system = nullptr) {
        if (!step.wants_residual) return 0;
        return (*this)(step.parallel, step.equation, step.velocities, system);
    }

  private:
    [[nodiscard]] float measure_elements(Parallel& parallel, const StepEquation& equation,
                                         std::span<const Vec4> velocities, ImplicitSystem& system);

    const ClothModel* model_;
    bool of_elements_;
    ScratchArray<Vec4> free_, left_;  // of finite elements: v_free, and what it or v leaves
};

}  // namespace weft
