#include "cloth/forces/spring_system.h"

#include <cmath>

#include "cloth/forces/springs.h"
#include "cloth/implicit/vectors.h"

namespace weft {

/// What one particle gathers.
struct SpringSystem::Row {
    Vector3 force = Vector3::Zero();    ///< [N]
    Vector3 impulse = Vector3::Zero();  ///< what b holds besides gamma force [kg m/s]
    float row_sum = 0;                  ///< [kg]
    Symmetric3 diagonal;
};

SpringSystem::SpringSystem(const CookedCloth& model)
    : ImplicitSystem(model.particle_count),
      model_(model),
      stencil_(model.spring_offsets.span(), model.neighbours.span()),
      rest_lengths_(stencil_.neighbours.size()),
      stiffness_(stencil_.neighbours.size()),
      coefficients_(4 * stencil_.neighbours.size()),
      inverse_diagonal_(model.particle_count),
      positions_(model.particle_count) {
    for (std::size_t e = 0; e < stencil_.entries.size(); ++e)
        rest_lengths_[stencil_.entries[e]] = model.rest_lengths[e];
}

void SpringSystem::set_stiffnesses(const Fabric& fabric) {
    const std::array<float, 3> of_kind = stiffnesses(fabric);
    if (of_kind == stiffness_of_kind_) return;
    stiffness_of_kind_ = of_kind;
    for (std::size_t e = 0; e < stencil_.entries.size(); ++e) {
        stiffness_[stencil_.entries[e]] = of_kind[static_cast<std::size_t>(model_.kinds[e])];
    }
}

void SpringSystem::place(Parallel& parallel, const StepEquation& equation, std::span<const Vec4> velocities) {
    parallel.ranges(model_.particle_count, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const Vec4& base = equation.base_positions[i];
            positions_[i] = to_vec4(xyz(base) + equation.gamma * xyz(velocities[i]), base.w);
        }
    });
}

// Inertia, gravity and air: everything in the row but springs.
SpringSystem::Row SpringSystem::external_row(const StepEquation& equation, const Vec4& position,
                                             const Vector3& v, std::uint32_t i) const {
    const ExternalForces& external = equation.external;
    const float mass = 1.0f / position.w;
    Row row;
    row.force = mass * (external.gravity - external.air_damping * v);
    row.impulse = mass * (xyz(equation.base_velocities[i]) - v);
    row.row_sum = mass * (1.0f + equation.gamma * external.air_damping);
    if (!external.air.empty()) {
        const Vec4& air = external.air[i];
        row.force += xyz(air) + air.w * (xyz(equation.velocities[i]) - v);
        row.row_sum += equation.gamma * air.w;
    }
    return row;
}

// Kang, eq. 4 and 5, with the springs' damping (c = damping k, along the spring) and the air's taken
// implicitly too:
//   W = M - gamma^2 J - gamma C,  b = M (v_base - v) + gamma (f + gamma J v about the base; f about the
//   iterate).
void SpringSystem::linearise(Parallel& parallel, const StepEquation& equation,
                             std::span<const Vec4> velocities, LinearisedAbout about) {
    set_stiffnesses(equation.settings.fabric);
    const bool about_base = about == LinearisedAbout::base;
    if (!about_base) place(parallel, equation, velocities);
    const std::span<const Vec4> positions = about_base ? equation.base_positions : positions_.span();
    const float gamma = equation.gamma, damping = equation.settings.fabric.damping;

    parallel.ranges(model_.particle_count, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            if (positions[i].w == 0) {
                right_side_[i] = {};
                inverse_diagonal_[i] = {};
                continue;
            }
            const Vector3 x = xyz(positions[i]), v = xyz(velocities[i]);
            Row row = external_row(equation, positions[i], v, i);
            const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
            for (std::uint32_t s = stencil_.group_slots[group]; s < stencil_.group_slots[group + 1]; ++s) {
                const std::uint32_t entry = s * Stencil::lanes + lane, j = stencil_.neighbours[entry];
                const float k = stiffness_[entry];
                const SpringTerms spring = spring_terms(xyz(positions[j]) - x, rest_lengths_[entry], k, i, j);
                const float a = gamma * gamma * spring.isotropic;
                const float viscous = gamma * damping * k;
                const float axial = gamma * gamma * spring.axial;
                const Vector3& n = spring.direction;
                const Vector3 relative_velocity = xyz(velocities[j]) - v;
                row.force += spring.force;
                row.impulse += (viscous + (about_base ? axial : 0.0f)) * n.dot(relative_velocity) * n;
                if (about_base) row.impulse += a * relative_velocity;
                const Vector3 d = std::sqrt(axial + viscous) * n;
                row.diagonal.add(a, d);
                coefficients_[lane_index(entry, 0, 4)] = a;
                for (std::uint32_t k3 = 0; k3 < 3; ++k3) coefficients_[lane_index(entry, k3 + 1, 4)] = d[k3];
            }
            row.diagonal.add(row.row_sum, Vector3::Zero());
            right_side_[i] = to_vec4(gamma * row.force + row.impulse, row.row_sum);
            inverse_diagonal_[i] = inverse(row.diagonal, row.row_sum);
        }
    });
}

void SpringSystem::residual(Parallel& parallel, const StepEquation& equation,
                            std::span<const Vec4> velocities, std::span<Vec4> residual) {
    set_stiffnesses(equation.settings.fabric);
    place(parallel, equation, velocities);
    const float gamma = equation.gamma, damping = equation.settings.fabric.damping;
    parallel.ranges(model_.particle_count, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            residual[i] = {};
            if (positions_[i].w == 0) continue;
            const Vector3 x = xyz(positions_[i]), v = xyz(velocities[i]);
            Row row = external_row(equation, positions_[i], v, i);
            const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
            for (std::uint32_t s = stencil_.group_slots[group]; s < stencil_.group_slots[group + 1]; ++s) {
                const std::uint32_t entry = s * Stencil::lanes + lane, j = stencil_.neighbours[entry];
                const float k = stiffness_[entry];
                const SpringTerms spring =
                    spring_terms(xyz(positions_[j]) - x, rest_lengths_[entry], k, i, j);
                const float stretching = spring.direction.dot(xyz(velocities[j]) - v);
                row.force += spring.force + damping * k * stretching * spring.direction;
            }
            residual[i] = to_vec4(gamma * row.force + row.impulse, 0);
        }
    });
}

Vector3 SpringSystem::row_product(std::span<const Vec4> x, std::uint32_t i) const {
    const float row_sum = right_side_[i].w;
    if (row_sum == 0) return Vector3::Zero();
    const Vector3 x_i = xyz(x[i]);
    Vector3 sum = row_sum * x_i;
    const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
    for (std::uint32_t s = stencil_.group_slots[group]; s < stencil_.group_slots[group + 1]; ++s) {
        const std::uint32_t entry = s * Stencil::lanes + lane;
        const Vector3 difference = x_i - xyz(x[stencil_.neighbours[entry]]);
        const float* c = &coefficients_[lane_index(entry, 0, 4)];
        const Vector3 d(c[Stencil::lanes], c[2 * Stencil::lanes], c[3 * Stencil::lanes]);
        sum += *c * difference + d.dot(difference) * d;
    }
    return sum;
}

double SpringSystem::multiply(Parallel& parallel, std::span<const Vec4> x, std::span<Vec4> product) {
    return sum_over_particles(parallel, model_.particle_count, partial_sums_.span(), [&](std::uint32_t i) {
        const Vector3 row = row_product(x, i);
        product[i] = to_vec4(row, 0);
        return static_cast<double>(row.dot(xyz(x[i])));
    });
}

void SpringSystem::relax(Parallel& parallel, std::span<const Vec4> b, std::span<const Vec4> x,
                         Relaxation relaxation, std::span<Vec4> next) {
    parallel.ranges(model_.particle_count, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const Vector3 x_i = xyz(x[i]);
            const Vector3 correction = inverse_diagonal_[i] * (xyz(b[i]) - row_product(x, i));
            next[i] =
                to_vec4(x_i + relaxation.step * correction + relaxation.momentum * (x_i - xyz(next[i])), 0);
        }
    });
}

void SpringSystem::precondition(Parallel& parallel, std::span<const Vec4> b, float step, std::span<Vec4> x) {
    parallel.ranges(model_.particle_count, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            x[i] = to_vec4(step * (inverse_diagonal_[i] * xyz(b[i])), 0);
    });
}

SpringBlocks SpringSystem::spring_blocks(Parallel& /*parallel*/) {
    return {stencil_, coefficients_.span()};
}

std::size_t SpringSystem::bytes() const noexcept {
    return ImplicitSystem::bytes() + stencil_.bytes() + rest_lengths_.bytes() + stiffness_.bytes() +
           coefficients_.bytes() + inverse_diagonal_.bytes() + positions_.bytes();
}

}  // namespace weft
