#include "demo/study/reference/step_functional.h"

#include <cmath>

#include "cloth/fabric/membrane.h"
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

}  // namespace weft::study
