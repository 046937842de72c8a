#include "cloth/forces/springs.h"

#include <cmath>
namespace weft {

namespace {

/// Stiffness by SpringKind.
std::array<float, 3> stiffnesses(const Fabric& fabric) {
    return {fabric.stretch, fabric.shear, fabric.bend};
}

/// Assembly of one row: what one particle gathers from its springs.
struct Row {
    Vector3 force = Vector3::Zero();  ///< elastic and external force [N]
    Vector3 viscous =
        Vector3::Zero();  ///< sum_j A_ij (v_j - v_i) [kg m/s]: h times damping force and viscous term h J v
    Symmetric3 diagonal;
};

}  // namespace

// Kang, eq. 4 and 5, with the springs' damping (c = damping k, along the spring) and the air's taken
// implicitly too:
//   W = M - h^2 J - h C,  b = h (f + h J v),  A_ij = h^2 K_ij + h c n n^T.
void assemble(Parallel& parallel, const CookedCloth& model, const ClothState& state, const Fabric& fabric,
              const ExternalForces& external, float h, ImplicitSystem& system) {
    const std::array<float, 3> stiffness_of = stiffnesses(fabric);
    const bool has_air = !external.triangle_air_forces.empty();

    const auto gather_springs = [&](std::uint32_t i, const Vector3& x, const Vector3& v, Row& row) {
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
            const std::uint32_t j = model.neighbours[e];
            const float stiffness = stiffness_of[static_cast<std::size_t>(model.kinds[e])];
            const SpringTerms spring =
                spring_terms(xyz(state.positions[j]) - x, model.rest_lengths[e], stiffness, i, j);
            const float a = h * h * spring.isotropic;
            const Vector3 d =
                std::sqrt(h * h * spring.axial + h * fabric.damping * stiffness) * spring.direction;
            const Vector3 relative_velocity = xyz(state.velocities[j]) - v;
            row.force += spring.force;
            row.viscous += a * relative_velocity + d * d.dot(relative_velocity);
            row.diagonal.add(a, d);
            system.coefficients[e] = to_vec4(d, a);
        }
    };
    const auto gather_air = [&](std::uint32_t i, Row& row) {
        float slope = 0;
        for (std::uint32_t c = model.corner_offsets[i]; c < model.corner_offsets[i + 1]; ++c) {
            const Vec4& air = external.triangle_air_forces[model.corner_triangles[c]];
            row.force += xyz(air);
            slope += air.w;
        }
        return slope;
    };

    parallel.ranges(state.size(), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const float inverse_mass = state.positions[i].w;
            if (inverse_mass == 0) {
                system.right_side[i] = {};
                system.inverse_diagonal[i] = {};
                continue;
            }
            const float mass = 1.0f / inverse_mass;
            const Vector3 v = xyz(state.velocities[i]);
            Row row;
            gather_springs(i, xyz(state.positions[i]), v, row);
            const float air_slope = has_air ? gather_air(i, row) : 0.0f;

            row.force += mass * (external.gravity - external.air_damping * v);
            const float row_sum = mass * (1.0f + h * external.air_damping) + h * air_slope;
            row.diagonal.add(row_sum, Vector3::Zero());
            system.right_side[i] = to_vec4(h * row.force + row.viscous, row_sum);
            system.inverse_diagonal[i] = inverse(row.diagonal, row_sum);
        }
    });
}

}  // namespace weft
