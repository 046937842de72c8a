#include "cloth/forces/wind.h"

#include <cmath>

namespace weft {

namespace {

constexpr float third = 1.0f / 3.0f;

}  // namespace

// With u the relative velocity, n the normal on the side to which the air streams and c = u.n / |u| >= 0:
//   drag  = 1/2 rho A c |u| Cd u               along the stream, by the area that faces it
//   lift  = 1/2 rho A c |u| Cl (|u| n - c u)   across it, greatest at 45 degrees, none head-on or edge-on
// (the flat-plate model of Keckeisen et al. 2004, "Modelling effects of wind fields in cloth animations",
// with lift that vanishes edge-on, so that the force is continuous where the side that faces the wind
// changes).
PlateForce plate_force(const Vector3& u, const Vector3& area_normal, const Wind& wind) {
    const float speed = u.norm();
    const float area = area_normal.norm();
    if (speed < 1e-6f || area < 1e-12f) return {Vector3::Zero(), 0};

    const float through = u.dot(area_normal) / area;  // u.n, signed
    const Vector3 n = std::copysign(1.0f, through) / area * area_normal;
    const float facing = std::abs(through);
    const float pressure = 0.5f * wind.air_density * area * facing;
    const Vector3 force = pressure * ((wind.drag - wind.lift * facing / speed) * u + wind.lift * speed * n);
    return {force, wind.air_density * area * speed * (wind.drag + wind.lift)};
}

void sample_wind(Parallel& parallel, const ClothState& state, const WindField& field,
                 std::span<Vec4> air_velocities) {
    parallel.ranges(state.size(), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            air_velocities[i] = to_vec4(field.velocity(xyz(state.positions[i])), 0);
        }
    });
}

void compute_air_forces(Parallel& parallel, const CookedCloth& model, const ClothState& state,
                        const Wind& wind, std::span<const Vec4> air_velocities,
                        std::span<Vec4> triangle_scratch, std::span<Vec4> particle_forces) {
    const auto mean_of = [](std::span<const Vec4> values, const Triangle& t) -> Vector3 {
        return third * (xyz(values[t[0]]) + xyz(values[t[1]]) + xyz(values[t[2]]));
    };
    const std::span<const Vec4> velocities = state.velocities.span();
    const Vector3 mean_wind = to_vector(wind.velocity);
    parallel.ranges(static_cast<std::uint32_t>(model.triangles.size()), [&](const BlockRange& range) {
        for (std::uint32_t t = range.begin; t < range.end; ++t) {
            const Triangle& triangle = model.triangles[t];
            const Vector3 a = xyz(state.positions[triangle[0]]), b = xyz(state.positions[triangle[1]]),
                          c = xyz(state.positions[triangle[2]]);
            const Vector3 air = air_velocities.empty() ? mean_wind : mean_of(air_velocities, triangle);
            const PlateForce plate =
                plate_force(air - mean_of(velocities, triangle), 0.5f * (b - a).cross(c - a), wind);
            triangle_scratch[t] = to_vec4(third * plate.force, third * plate.slope);
        }
    });
    parallel.ranges(model.particle_count, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            Vector4 sum = Vector4::Zero();
            for (std::uint32_t c = model.corner_offsets[i]; c < model.corner_offsets[i + 1]; ++c) {
                sum += load(triangle_scratch[model.corner_triangles[c]]);
            }
            particle_forces[i] = to_vec4(sum.head<3>(), sum.w());
        }
    });
}

}  // namespace weft
