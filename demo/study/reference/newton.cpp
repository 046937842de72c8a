#include "demo/study/reference/newton.h"

#include <algorithm>

namespace weft::study {

namespace {

constexpr int most_iterations = 1000;

/// The step length in (0, 1] that lowers the functional enough (Armijo 1966). Near the solution, where
/// differences of the functional drown in rounding, it is 1.
double line_search(const StepFunctional& functional, const Flat& v, const Flat& direction,
                   const Flat& residual) {
    const std::vector<Eigen::Vector3d> along = functional.directions(v);
    const double start = functional.value(v, along), slope = -residual.dot(direction);
    const double rounding = 1e-13 * std::abs(start);
    double length = 1;
    while (length > 1e-8 &&
           functional.value(v + length * direction, along) > start + 1e-4 * length * slope + rounding)
        length /= 2;
    return length;
}

}  // namespace

Newton::Newton(const SolverStep& step, const StepFunctional& functional, std::uint32_t direct_up_to)
    : matrix_(functional.particles(), pairs_of(functional.springs())),
      exact_solve_(functional.particles(), direct_up_to) {
    if (exact_solve_.is_direct()) return;
    system_ = make_system(step.model, step.settings);
    velocities_ = AlignedBuffer<Vec4>(functional.particles());
}

NewtonResult Newton::minimise(const SolverStep& step, const StepFunctional& functional, double tolerance) {
    NewtonResult result{functional.start(), {}, false};
    Flat residual = functional.residual(result.velocities);
    const double first = residual.norm();
    result.residuals.push_back(first);
    while (result.residuals.size() <= most_iterations) {
        result.converged = residual.norm() <= tolerance * first;
        if (result.converged) break;
        precondition_at(step, result.velocities);
        const Flat change = direction(functional, result.velocities, residual, residual.norm() / first);
        result.velocities += line_search(functional, result.velocities, change, residual) * change;
        residual = functional.residual(result.velocities);
        result.residuals.push_back(residual.norm());
    }
    return result;
}

void Newton::precondition_at(const SolverStep& step, const Flat& v) {
    if (exact_solve_.is_direct()) return;
    for (std::size_t i = 0; i < velocities_.size(); ++i) {
        const Eigen::Vector3d v_i = v.segment<3>(3 * static_cast<Eigen::Index>(i));
        velocities_[i] = to_vec4(v_i.cast<float>(), 0);
    }
    system_->linearise(step.parallel, step.equation, velocities_.span(), LinearisedAbout::iterate);
    if (cycle_)
        cycle_->rebuild();
    else
        cycle_.emplace(step.parallel, *system_, step.equation.positions);
}

// While far from the solution the linear system need not be solved further than its model holds (Eisenstat
// and Walker 1996); there the exact matrix is seldom positive definite, either.
Flat Newton::direction(const StepFunctional& functional, const Flat& v, const Flat& residual, double left) {
    const auto cycle = [&](const Flat& r, Flat& z) { cycle_->apply(r, z); };
    Flat step;
    const double tolerance = std::clamp(0.1 * left, 1e-10, 1e-2);
    if (left < 0.1) {
        functional.hessian(v, Curvature::exact, matrix_);
        if (exact_solve_.solve(matrix_, residual, tolerance, cycle, step)) return step;
    }
    functional.hessian(v, Curvature::projected, matrix_);
    exact_solve_.solve(matrix_, residual, tolerance, cycle, step);
    return step;
}

float ConvergedSolver::solve(const SolverStep& step) {
    const StepFunctional functional(step.model, step.equation);
    if (!newton_) newton_ = std::make_unique<Newton>(step, functional);
    const NewtonResult result = newton_->minimise(step, functional, tolerance_);
    for (std::uint32_t i = 0; i < functional.particles(); ++i) {
        const Eigen::Index at = 3 * static_cast<Eigen::Index>(i);
        const Eigen::Vector3d change = result.velocities.segment<3>(at) - functional.start().segment<3>(at);
        step.velocity_change[i] = to_vec4(change.cast<float>(), 0);
    }
    return static_cast<float>(result.residuals.back() / result.residuals.front());
}

}  // namespace weft::study
