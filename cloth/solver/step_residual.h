#pragma once
// The relative residual of a step's velocities in its equation: one figure with one meaning for every method.

#include <cstdint>
#include <span>

#include "cloth/equation/implicit_system.h"
#include "cloth/equation/step_equation.h"
#include "cloth/mesh/cook.h"
#include "cloth/solver/solver.h"
#include "engine/memory/scratch.h"

namespace weft {

/// |D^-1 r(v)| / max(|D^-1 r(v_free)|, |D^-1 M (v_free - v_base)|), where r(v) = gamma f(x_base + gamma v, v)
/// - M (v - v_base), contacts included, D is the diagonal of each particle in it, and v_free is the velocity
/// under external forces alone. 0: the equation is solved; 1: fabric and contacts have done nothing. The norm
/// of the impulses that are left is compared with that of the impulses of fabric and contacts.
///
/// Springs are sampled at one particle in 1024, at least 4, the same ones in every step: less than a
/// hundredth of a step's cost. Finite elements are all measured, which costs a quarter of a step.
class StepResidual {
  public:
    StepResidual(const ClothModel& model, const ClothSettings& settings)
        : model_(&model), of_elements_(settings.finite_elements.enabled) {}
    /// The residual of another cloth of that model.
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
    /// The residual of a solver's result; 0 where the step wants none.
    [[nodiscard]] float operator()(const SolverStep& step, ImplicitSystem* system = nullptr) {
        if (!step.wants_residual) return 0;
        return (*this)(step.parallel, step.equation, step.velocities, system);
    }

  private:
    [[nodiscard]] float measure_elements(Parallel& parallel, const StepEquation& equation,
                                         std::span<const Vec4> velocities, ImplicitSystem& system);

    const ClothModel* model_;
    bool of_elements_;
    ScratchArray<Vec4> free_, left_;  // for finite elements: v_free, and r at v_free or v
};

}  // namespace weft
