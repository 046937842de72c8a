#include "cloth/solvers/linear/linear_solver.h"

#include "cloth/solvers/make_system.h"

namespace weft {

LinearSolver::LinearSolver(const CookedCloth& model, const ClothSettings& settings)
    : system_(make_system(model, settings)), mean_motion_(model) {}

float LinearSolver::solve(const SolverStep& step) {
    {
        const auto timer = step.timed(Stage::assemble);
        system_->linearise(step.parallel, step.equation, step.equation.velocities, LinearisedAbout::base);
    }
    const auto timer = step.timed(Stage::solve);
    // Cloth that lies on something is held by it: its mean motion is not free.
    const bool apart = solves_mean_motion_apart(step.settings) && !step.touches_collider;
    if (apart) mean_motion_.take_out(step.parallel, step.model, system_->right_side().span());
    const float residual = solve_linear(step, *system_);
    if (apart)
        mean_motion_.put_back(step.parallel, step.model, system_->right_side().span(), step.velocity_change);
    return residual;
}

std::size_t LinearSolver::bytes() const noexcept {
    return system_->bytes() + mean_motion_.bytes();
}

}  // namespace weft
