#include "demo/study/explicit_euler.h"

#include <algorithm>

namespace weft::study {

ExplicitEulerSolver::ExplicitEulerSolver(const CookedCloth& model, const ClothSettings& settings)
    : forces_(model, settings), pending_(model.particle_count), velocities_(model.particle_count) {}

float ExplicitEulerSolver::solve(const SolverStep& step) {
    std::ranges::copy(pending_.span(), step.velocity_change.begin());
    for (std::size_t i = 0; i < velocities_.size(); ++i) {
        velocities_[i] = to_vec4(xyz(step.equation.velocities[i]) + xyz(pending_[i]), 0);
    }
    StepEquation present = step.equation;
    present.velocities = velocities_.span();
    present.base_velocities = velocities_.span();
    return forces_.solve({.parallel = step.parallel,
                          .profiler = step.profiler,
                          .model = step.model,
                          .settings = step.settings,
                          .equation = present,
                          .touches_collider = step.touches_collider,
                          .velocity_change = pending_.span()});
}

std::size_t ExplicitEulerSolver::bytes() const noexcept {
    return forces_.bytes() + pending_.bytes() + velocities_.bytes();
}

}  // namespace weft::study
