#include "cloth/forces/wind.h"

#include <cmath>

namespace weft {

namespace {

constexpr float third = 1.0f / 3.0f;

}  // namespace

// With u the relative velocity, n the normal on the side to which the air streams and c = u.n / |u| >= 0:
//   drag  = 1/2 rho A c |u| Cd u               along the stream, by the area that faces it
//   lift  = 1/2 rho A c |u| Cl (|u| n - c u)   across it, greatest at 45 degrees, none head-on or edge-on
// (the flat-plate model of Keckeisen et al. 2004, "Modelling effects of wind fields in cloth animations", with lift that vanishes
// edge-on, so that the force is continuous where the side that faces the wind changes).
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

void sample_wind(Parallel& parallel, const CookedCloth& model, const ClothState& state,
                 const WindField& field, std::span<Vec4> air_velocities) {
    parallel.ranges(static_cast<std::uint32_t>(model.triangles.size()), [&](const BlockRange& range) {
        for (std::uint32_t t = range.begin; t < range.end; ++t) {
            const auto [a, b, c] = model.triangles[t];
            const Vector3 centroid =
                third * (xyz(state.positions[a]) + xyz(state.positions[b]) + xyz(state.positions[c]));
            air_velocities[t] = to_vec4(field.velocity(centroid), 0);
        }
    });
}

void compute_air_forces(Parallel& parallel, const CookedCloth& model, const ClothState& state,
                        const Wind& wind, std::span<const Vec4> air_velocities,
                        std::span<Vec4> triangle_forces) {
    const Vector3 mean = to_vector(wind.velocity);
    parallel.ranges(static_cast<std::uint32_t>(model.triangles.size()), [&](const BlockRange& range) {
        for (std::uint32_t t = range.begin; t < range.end; ++t) {
            const auto [a, b, c] = model.triangles[t];
            const Vector3 xa = xyz(state.positions[a]);
            const Vector3 area_normal =
                0.5f * (xyz(state.positions[b]) - xa).cross(xyz(state.positions[c]) - xa);
            const Vector3 velocity =
                third * (xyz(state.velocities[a]) + xyz(state.velocities[b]) + xyz(state.velocities[c]));
            const Vector3 air = air_velocities.empty() ? mean : xyz(air_velocities[t]);
            const PlateForce plate = plate_force(air - velocity, area_normal, wind);
            triangle_forces[t] = to_vec4(third * plate.force, third * plate.slope);
        }
    });
}

}  // namespace weft
