#include "cloth/forces/spring_system.h"

#include <cmath>

#include "cloth/forces/springs.h"
#include "cloth/implicit/symmetric3.h"
#include "cloth/implicit/vectors.h"

namespace weft {

/// What one particle gathers.
struct SpringSystem::Row {
    Vector3 force = Vector3::Zero();    ///< [N]
    Vector3 impulse = Vector3::Zero();  ///< what b holds besides gamma force [kg m/s]
    float row_sum = 0;                  ///< [kg]
    Symmetric3 diagonal;
};

static void store_diagonal(SpringMatrix& matrix, std::uint32_t i, float row_sum, const Symmetric3& inverse) {
    matrix.row_sums[i] = row_sum;
    const float values[] = {inverse.xx, inverse.yy, inverse.zz, inverse.xy, inverse.xz, inverse.yz};
    for (std::uint32_t k = 0; k < 6; ++k) matrix.inverse_diagonal[lane_index(i, k, 6)] = values[k];
}

SpringSystem::SpringSystem(const CookedCloth& model)
    : ImplicitSystem(model.particle_count),
      model_(model),
      matrix_(Stencil(model.spring_offsets.span(), model.neighbours.span())),
      rest_lengths_(matrix_.stencil.neighbours.size()),
      stiffness_(matrix_.stencil.neighbours.size()),
      positions_(model.particle_count) {
    for (std::size_t e = 0; e < matrix_.stencil.entries.size(); ++e)
        rest_lengths_[matrix_.stencil.entries[e]] = model.rest_lengths[e];
}

void SpringSystem::set_stiffnesses(const Fabric& fabric) {
    const std::array<float, 3> of_kind = stiffnesses(fabric);
    if (of_kind == stiffness_of_kind_) return;
    stiffness_of_kind_ = of_kind;
    for (std::size_t e = 0; e < matrix_.stencil.entries.size(); ++e) {
        stiffness_[matrix_.stencil.entries[e]] = of_kind[static_cast<std::size_t>(model_.kinds[e])];
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
                store_diagonal(matrix_, i, 0, {});
                continue;
            }
            const Vector3 x = xyz(positions[i]), v = xyz(velocities[i]);
            Row row = external_row(equation, positions[i], v, i);
            const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
            for (std::uint32_t s = matrix_.stencil.group_slots[group];
                 s < matrix_.stencil.group_slots[group + 1]; ++s) {
                const std::uint32_t entry = s * Stencil::lanes + lane, j = matrix_.stencil.neighbours[entry];
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
                matrix_.coefficients[lane_index(entry, 0, 4)] = a;
                for (std::uint32_t k3 = 0; k3 < 3; ++k3)
                    matrix_.coefficients[lane_index(entry, k3 + 1, 4)] = d[k3];
            }
            row.diagonal.add(row.row_sum, Vector3::Zero());
            right_side_[i] = to_vec4(gamma * row.force + row.impulse, row.row_sum);
            store_diagonal(matrix_, i, row.row_sum, inverse(row.diagonal, row.row_sum));
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
            for (std::uint32_t s = matrix_.stencil.group_slots[group];
                 s < matrix_.stencil.group_slots[group + 1]; ++s) {
                const std::uint32_t entry = s * Stencil::lanes + lane, j = matrix_.stencil.neighbours[entry];
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

double SpringSystem::multiply(Parallel& parallel, std::span<const Vec4> x, std::span<Vec4> product) {
    return parallel.reduce(
        model_.particle_count, partial_sums_.span(), 0.0,
        [&](const BlockRange& range) { return multiply_block(matrix_, range, x.data(), product.data()); },
        std::plus<>{});
}

void SpringSystem::relax(Parallel& parallel, std::span<const Vec4> b, std::span<const Vec4> x,
                         Relaxation relaxation, std::span<Vec4> next) {
    parallel.ranges(model_.particle_count, [&](const BlockRange& range) {
        relax_block(matrix_, range, b.data(), x.data(), relaxation, next.data());
    });
}

void SpringSystem::precondition(Parallel& parallel, std::span<const Vec4> b, float step, std::span<Vec4> x) {
    parallel.ranges(model_.particle_count, [&](const BlockRange& range) {
        precondition_block(matrix_, range, b.data(), step, x.data());
    });
}

SpringBlocks SpringSystem::spring_blocks(Parallel& /*parallel*/) {
    return {matrix_.stencil, matrix_.coefficients.span()};
}

std::size_t SpringSystem::bytes() const noexcept {
    return ImplicitSystem::bytes() + matrix_.bytes() + rest_lengths_.bytes() + stiffness_.bytes() +
           positions_.bytes();
}

}  // namespace weft
