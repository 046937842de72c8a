#include "demo/study/reference/newton.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cloth/fabric/springs/membrane.h"
#include "cloth/solver/make_system.h"
#include "engine/separating_direction.h"

namespace weft::study {

namespace {

Eigen::Index at(std::uint32_t particle) {
    return 3 * static_cast<Eigen::Index>(particle);
}

Eigen::Vector3d direction_of(const Spring& spring, const Eigen::Vector3d& separation) {
    const double length = separation.norm();
    if (length > 1e-12) return separation / length;
    return separating_direction(spring.j, spring.i).cast<double>();
}

}  // namespace

std::vector<Spring> springs_of(const ClothModel& model, const Fabric& fabric) {
    std::vector<float> stiffness(model.neighbours.size());
    spring_stiffness(model, fabric, stiffness);
    std::vector<Spring> springs;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
            const std::uint32_t j = model.neighbours[e];
            if (j < i) continue;
            springs.push_back({i, j, static_cast<double>(stiffness[e]),
                               static_cast<double>(model.rest_lengths[e]),
                               static_cast<double>(fabric.bending) * static_cast<double>(model.bending[e])});
        }
    }
    return springs;
}

std::vector<ParticlePair> pairs_of(std::span<const Spring> springs) {
    std::vector<ParticlePair> pairs;
    for (const Spring& spring : springs) pairs.push_back({spring.i, spring.j});
    return pairs;
}

Flat flat(std::span<const Vec4> values) {
    Flat result(3 * static_cast<Eigen::Index>(values.size()));
    for (std::uint32_t i = 0; i < values.size(); ++i)
        result.segment<3>(at(i)) = xyz(values[i]).cast<double>();
    return result;
}

StepFunctional::StepFunctional(const ClothModel& model, const StepEquation& equation)
    : gamma_(static_cast<double>(equation.gamma)),
      damping_(static_cast<double>(equation.settings.fabric.damping)),
      air_damping_(static_cast<double>(equation.external.air_damping)),
      gravity_(equation.external.gravity.cast<double>()),
      springs_(springs_of(model, equation.settings.fabric)),
      start_(flat(equation.velocities)),
      base_positions_(flat(equation.base_positions)),
      base_velocities_(flat(equation.base_velocities)) {
    for (const Vec4& position : equation.positions)
        masses_.push_back(position.w > 0 ? 1.0 / static_cast<double>(position.w) : 0.0);
    for (const Vec4& air : equation.external.air) {
        air_.emplace_back(xyz(air).cast<double>());
        air_slopes_.push_back(static_cast<double>(air.w));
    }
}

Eigen::Vector3d StepFunctional::separation(const Spring& spring, const Flat& v) const {
    const auto difference = [&](const Flat& values) -> Eigen::Vector3d {
        return values.segment<3>(at(spring.j)) - values.segment<3>(at(spring.i));
    };
    return difference(base_positions_) + gamma_ * difference(v);
}

std::vector<DampedState> StepFunctional::damped_states(const Flat& v) const {
    std::vector<DampedState> result;
    result.reserve(springs_.size());
    for (const Spring& spring : springs_) {
        const Eigen::Vector3d n = direction_of(spring, separation(spring, v));
        result.push_back({n, n.dot(v.segment<3>(at(spring.j)) - v.segment<3>(at(spring.i)))});
    }
    return result;
}

double StepFunctional::value(const Flat& v, std::span<const DampedState> damped) const {
    double value = 0;
    for (std::uint32_t i = 0; i < particles(); ++i) {
        if (masses_[i] == 0) continue;
        const Eigen::Vector3d v_i = v.segment<3>(at(i));
        value += 0.5 * masses_[i] * (v_i - base_velocities_.segment<3>(at(i))).squaredNorm();
        value += gamma_ * masses_[i] * (0.5 * air_damping_ * v_i.squaredNorm() - gravity_.dot(v_i));
        if (air_.empty()) continue;
        const Eigen::Vector3d change = v_i - start_.segment<3>(at(i));
        value += gamma_ * (0.5 * air_slopes_[i] * change.squaredNorm() - air_[i].dot(change));
    }
    for (std::size_t s = 0; s < springs_.size(); ++s) {
        const Spring& spring = springs_[s];
        const auto& [direction, stretching] = damped[s];
        const double strain = separation(spring, v).norm() - spring.rest_length;
        const double change =
            direction.dot(v.segment<3>(at(spring.j)) - v.segment<3>(at(spring.i))) - stretching;
        value += spring.stiffness * (0.5 * strain * strain + damping_ * stretching * strain +
                                     0.5 * gamma_ * damping_ * change * change);
        const Eigen::Vector3d apart = v.segment<3>(at(spring.j)) - v.segment<3>(at(spring.i));
        value += 0.5 * spring.bending *
                 (separation(spring, v).squaredNorm() + gamma_ * damping_ * apart.squaredNorm());
    }
    return value;
}

Flat StepFunctional::residual(const Flat& v) const {
    Flat residual = Flat::Zero(v.size());
    for (const Spring& spring : springs_) {
        const Eigen::Vector3d d = separation(spring, v), n = direction_of(spring, d);
        const Eigen::Vector3d apart = v.segment<3>(at(spring.j)) - v.segment<3>(at(spring.i));
        const double tension = spring.stiffness * (d.norm() - spring.rest_length + damping_ * n.dot(apart));
        const Eigen::Vector3d pull = tension * n + spring.bending * (d + damping_ * apart);
        residual.segment<3>(at(spring.i)) += gamma_ * pull;
        residual.segment<3>(at(spring.j)) -= gamma_ * pull;
    }
    for (std::uint32_t i = 0; i < particles(); ++i) {
        auto r_i = residual.segment<3>(at(i));
        if (masses_[i] == 0) {
            r_i.setZero();
            continue;
        }
        const Eigen::Vector3d v_i = v.segment<3>(at(i));
        r_i += masses_[i] *
               (gamma_ * (gravity_ - air_damping_ * v_i) + base_velocities_.segment<3>(at(i)) - v_i);
        if (!air_.empty()) r_i += gamma_ * (air_[i] - air_slopes_[i] * (v_i - start_.segment<3>(at(i))));
    }
    return residual;
}

void StepFunctional::hessian(const Flat& v, Curvature curvature, BlockMatrix& matrix) const {
    matrix.set_zero();
    for (std::uint32_t i = 0; i < particles(); ++i) {
        double mass = 1;  // of pinned particles, which are not coupled to others
        if (masses_[i] > 0) {
            mass = masses_[i] * (1 + gamma_ * air_damping_);
            if (!air_.empty()) mass += gamma_ * air_slopes_[i];
        }
        matrix.add_diagonal(i, mass * Eigen::Matrix3d::Identity());
    }
    for (std::size_t s = 0; s < springs_.size(); ++s) {
        const Spring& spring = springs_[s];
        const Eigen::Vector3d d = separation(spring, v), n = direction_of(spring, d);
        const double length = std::max(d.norm(), 1e-12);
        const double stretching = n.dot(v.segment<3>(at(spring.j)) - v.segment<3>(at(spring.i)));
        // Kang's K over k, across the spring: its tension over its length, the damping's tension included.
        double across = (length - spring.rest_length + damping_ * stretching) / length;
        if (curvature == Curvature::projected) across = std::max(across, 0.0);
        const Eigen::Matrix3d along = n * n.transpose();
        const Eigen::Matrix3d stiffness =
            spring.stiffness * gamma_ *
                (gamma_ * across * (Eigen::Matrix3d::Identity() - along) + (gamma_ + damping_) * along) +
            spring.bending * gamma_ * (gamma_ + damping_) * Eigen::Matrix3d::Identity();
        const bool i_is_free = masses_[spring.i] > 0, j_is_free = masses_[spring.j] > 0;
        if (i_is_free) matrix.add_diagonal(spring.i, stiffness);
        if (j_is_free) matrix.add_diagonal(spring.j, stiffness);
        if (i_is_free && j_is_free) matrix.add_pair(s, -stiffness);
    }
}

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
