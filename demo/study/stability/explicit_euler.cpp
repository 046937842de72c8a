#include "demo/study/stability/explicit_euler.h"

#include <algorithm>

namespace weft::study {

ExplicitEulerSolver::ExplicitEulerSolver(const ClothModel& model, const ClothSettings& settings)
    : forces_(model, settings),
      pending_(model.particle_count),
      velocities_(model.particle_count),
      next_(model.particle_count) {}

SolveResult ExplicitEulerSolver::solve(const SolverStep& step) {
    for (std::size_t i = 0; i < velocities_.size(); ++i) {
        velocities_[i] = to_vec4(xyz(step.equation.velocities[i]) + xyz(pending_[i]), 0);
    }
    std::ranges::copy(velocities_.span(), step.velocities.begin());
    StepEquation present = step.equation;
    present.velocities = velocities_.span();
    present.base_velocities = velocities_.span();
    const SolveResult result = forces_.solve({.parallel = step.parallel,
                                              .profiler = step.profiler,
                                              .model = step.model,
                                              .settings = step.settings,
                                              .equation = present,
                                              .velocities = next_.span()});
    for (std::size_t i = 0; i < velocities_.size(); ++i)
        pending_[i] = to_vec4(xyz(next_[i]) - xyz(velocities_[i]), 0);
    return result;
}

std::size_t ExplicitEulerSolver::bytes() const noexcept {
    return forces_.bytes() + pending_.bytes() + velocities_.bytes() + next_.bytes();
}

}  // namespace weft::study
