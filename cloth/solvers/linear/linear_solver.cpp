#include "cloth/solvers/linear/linear_solver.h"

#include "cloth/system/sparse/vectors.h"

namespace weft {

LinearSolver::LinearSolver(const CookedCloth& model, const ClothSettings& settings)
    : kind_(settings), system_(make_system(model, settings)), mean_motion_(model) {}

SolveResult LinearSolver::solve(const SolverStep& step) {
    {
        const auto timer = step.timed(Stage::assemble);
        system_->linearise(step.parallel, step.equation, step.equation.velocities, LinearisedAbout::base);
    }
    const auto timer = step.timed(Stage::solve);
    const std::span<Vec4> dv = step.velocities;
    // Cloth that lies on something is held by it: its mean motion is not free.
    const bool apart = solves_mean_motion_apart(step.settings) && step.equation.contacts == nullptr;
    if (apart) mean_motion_.take_out(step.parallel, step.model, system_->right_side().span());
    const SolveResult result = solve_linear(step, *system_, dv);
    if (apart) mean_motion_.put_back(step.parallel, step.model, system_->right_side().span(), dv);
    scale_and_add(step.parallel, 1.0f, step.equation.velocities, 1.0f, step.velocities);
    return result;
}

std::size_t LinearSolver::bytes() const noexcept {
    return system_->bytes() + mean_motion_.bytes();
}

}  // namespace weft
