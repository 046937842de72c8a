#include "demo/study/reference/newton.h"
#include "cloth/solver/make_system.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace weft::study {

namespace {

constexpr std::size_t most_iterations = 1000;
constexpr std::size_t most_in_vain = 20;  // iterations that do not halve the residual

/// The step length in (0, 1] that lowers the functional enough (Armijo 1966). Near the solution, where
/// differences of the functional drown in rounding, it is 1.
double line_search(const StepFunctional& functional, const Flat& v, const Flat& direction,
                   const Flat& residual) {
    const std::vector<DampedState> damped = functional.damped_states(v);
    const double start = functional.value(v, damped), slope = -residual.dot(direction);
    const double rounding = 1e-13 * std::abs(start);
    double length = 1;
    while (length > 1e-8 &&
           functional.value(v + length * direction, damped) > start + 1e-4 * length * slope + rounding)
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

// Where cloth is about to buckle the functional is all but flat along some motions. There the part of the
// damping's slope that has no potential, which the matrix lacks, can keep the iterates wandering about the
// solution.
NewtonResult Newton::minimise(const SolverStep& step, const StepFunctional& functional, double tolerance,
                              const Flat& nearby) {
    NewtonResult best{functional.start(), {}, false};
    Flat residual = functional.residual(best.velocities);
    const double first = residual.norm();
    double least = first;
    best.residuals.push_back(first);
    if (nearby.size() > 0) {
        const Flat there = functional.residual(nearby);
        if (there.norm() < first) {
            best.velocities = nearby;
            residual = there;
            least = residual.norm();
            best.residuals.push_back(least);
        }
    }
    Flat v = best.velocities;
    std::size_t best_at = 0;
    const auto wanders = [&] {
        return least < 1e-4 * first && best.residuals.size() > best_at + most_in_vain;
    };
    while (least > tolerance * first && best.residuals.size() <= most_iterations && !wanders()) {
        precondition_at(step, v);
        const Flat change = direction(functional, v, residual, residual.norm() / first);
        v += line_search(functional, v, change, residual) * change;
        residual = functional.residual(v);
        best.residuals.push_back(residual.norm());
        if (residual.norm() >= least) continue;
        if (residual.norm() < 0.5 * least) best_at = best.residuals.size();
        least = residual.norm();
        best.velocities = v;
    }
    best.converged = least <= tolerance * first;
    return best;
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

// Far from the solution the linear system need not be solved further than its model holds (Eisenstat and
// Walker 1996). The exact matrix is seldom positive definite there.
Flat Newton::direction(const StepFunctional& functional, const Flat& v, const Flat& residual, double left) {
    const auto cycle = [&](const Flat& r, Flat& z) { cycle_->apply(r, z); };
    Flat step;
    const double tolerance = std::clamp(0.1 * left, 1e-10, 1e-2);
    if (left < 0.1) {
        functional.hessian(v, Curvature::exact, matrix_);
        const bool is_definite = exact_solve_.solve(matrix_, residual, tolerance, cycle, step);
        if (is_definite || !exact_solve_.is_direct()) return step;
    }
    functional.hessian(v, Curvature::projected, matrix_);
    exact_solve_.solve(matrix_, residual, tolerance, cycle, step);
    return step;
}

ConvergedSolver::ConvergedSolver(const ClothModel& model, const ClothSettings& settings)
    : approach_settings_(settings) {
    if (model.particle_count <= ExactSolve::usual_limit) return;
    approach_settings_.method = Multilevel{.passes = 60};
    approach_ = std::make_unique<MultilevelSolver>(model, approach_settings_, model.positions.span());
    approach_->lay_out_alone();
}

void ConvergedSolver::inverse_mass_changed(std::uint32_t particle, std::span<const Vec4> positions) noexcept {
    if (approach_) approach_->inverse_mass_changed(particle, positions);
}

void ConvergedSolver::inverse_masses_changed(std::span<const Vec4> positions) noexcept {
    if (approach_) approach_->inverse_masses_changed(positions);
}

Flat ConvergedSolver::approach(const SolverStep& step) {
    if (!approach_) return {};
    const SolveResult result = approach_->solve({.parallel = step.parallel,
                                                 .profiler = step.profiler,
                                                 .model = step.model,
                                                 .settings = approach_settings_,
                                                 .equation = step.equation,
                                                 .air = step.air,
                                                 .velocities = step.velocities});
    return result.ok ? flat(step.velocities) : Flat();
}

// The functional's air is linear. It is taken anew at each solution, until that no longer changes.
SolveResult ConvergedSolver::solve(const SolverStep& step) {
    constexpr int most_rounds = 30;
    Flat solution = approach(step);
    double left = 0;
    for (int round = 0; round < most_rounds; ++round) {
        if (solution.size() > 0) step.air.linearise(step.parallel, step.velocities);
        const StepFunctional functional(step.model, step.equation);
        if (step.model.particle_count > largest_for_newton && solution.size() > 0)
            return {.residual = static_cast<float>(functional.residual(solution).norm() /
                                                   functional.residual(functional.start()).norm())};
        if (!newton_) newton_ = std::make_unique<Newton>(step, functional);
        const NewtonResult result = newton_->minimise(step, functional, converged, solution);
        left = *std::ranges::min_element(result.residuals) / result.residuals.front();
        const Flat before = std::exchange(solution, result.velocities);
        for (std::uint32_t i = 0; i < functional.particles(); ++i) {
            const Eigen::Index at = 3 * static_cast<Eigen::Index>(i);
            step.velocities[i] = to_vec4(solution.segment<3>(at).cast<float>(), 0);
        }
        if (step.air.surface == nullptr) break;
        if (before.size() > 0 && (solution - before).norm() <= air_tolerance * solution.norm()) break;
    }
    return {.residual = static_cast<float>(left)};
}

}  // namespace weft::study
