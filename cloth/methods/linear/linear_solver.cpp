#include "cloth/methods/linear/linear_solver.h"

#include "cloth/equation/sparse/vectors.h"

namespace weft {

LinearSolver::LinearSolver(const ClothModel& model, const ClothSettings& settings)
    : kind_(settings),
      system_(make_system(model, settings)),
      mean_motion_(model),
      residual_(model, settings) {}

LinearSolver::LinearSolver(const LinearSolver& other, const ClothModel& model)
    : kind_(other.kind_),
      system_(other.system_->clone(model)),
      mean_motion_(other.mean_motion_),
      residual_(other.residual_, model) {}

void LinearSolver::lay_out(Scratch& scratch, std::size_t pairs) {
    Solver::lay_out(scratch, pairs);
    system_->lay_out(scratch);
    residual_.lay_out(scratch);
}

SolveResult LinearSolver::solve(const SolverStep& step) {
    {
        const auto timer = step.timed(Stage::assemble);
        system_->linearise(step.parallel, step.equation, step.equation.velocities, LinearisedAbout::base);
    }
    const auto timer = step.timed(Stage::solve);
    const std::span<Vec4> dv = step.velocities;
    const bool apart = solves_mean_motion_apart(step.settings);
    if (apart) mean_motion_.take_out(step.parallel, system_->contacts(), system_->right_side().span());
    const bool ok = solve_linear(step, *system_, dv);
    const std::span<const Vec4> velocities = step.equation.velocities;
    if (apart)
        mean_motion_.put_back(step.parallel, system_->contacts(), system_->right_side().span(), velocities,
                              dv);
    else
        scale_and_add(step.parallel, 1.0f, velocities, 1.0f, dv);
    return {.residual = residual_(step, system_.get()), .ok = ok};
}

std::size_t LinearSolver::bytes() const noexcept {
    return system_->bytes() + mean_motion_.bytes();
}

}  // namespace weft
