#include "cloth/forces/wind.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/forces/wind.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/triangle_groups-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

HWY_INLINE Lanes set(float value) {
    return hn::Set(Tag(), value);
}

HWY_INLINE PackedRows sum_over_corners(const TriangleGroups& groups, std::uint32_t t, const Vec4* rows) {
    return corner_rows(groups, t, 0, rows) + corner_rows(groups, t, 1, rows) +
           corner_rows(groups, t, 2, rows);
}

/// The air's velocity minus the triangles' [m/s].
HWY_INLINE Lanes3 relative_velocity(const TriangleGroups& groups, std::uint32_t t, const Vec4* velocities,
                                    const Lanes3& mean_wind, std::span<const Vec4> air_velocities) {
    const Lanes third = set(1.0f / 3.0f);
    const PackedRows sum = sum_over_corners(groups, t, velocities);
    if (air_velocities.empty()) return mean_wind - third * unpacked(sum);
    return third * unpacked(sum_over_corners(groups, t, air_velocities.data()) - sum);
}

// With u the relative velocity, n the normal on the side to which the air streams and c = u.n / |u| >= 0:
//   drag  = 1/2 rho A c |u| Cd u               along the stream, by the area that faces it
//   lift  = 1/2 rho A c |u| Cl (|u| n - c u)   across it, greatest at 45 degrees, none head-on or edge-on
// (the flat-plate model of Keckeisen et al. 2004, "Modelling effects of wind fields in cloth animations",
// with lift that vanishes edge-on, so that the force is continuous where the side that faces the wind
// changes). With N = 2 A n as it is stored:
//   c = |u.N| / (|u| |N|),   |u| n = sign(u.N) |u|^2 / (|u| |N|) N
void air_forces_of(const TriangleGroups& groups, const BlockRange& range, const Wind& wind,
                   const Vec4* velocities, std::span<const Vec4> air_velocities, Vec4* triangle_rows) {
    const Lanes3 mean_wind = {set(wind.velocity.x), set(wind.velocity.y), set(wind.velocity.z)};
    const Lanes drag = set(wind.drag), lift = set(wind.lift);
    const Lanes to_pressure = set(wind.air_density / 12);  // of a third of the triangle, by 2 A
    const Lanes to_slope = set(wind.air_density / 6 * (wind.drag + wind.lift));
    for (std::uint32_t t = range.begin; t < range.end; t += part_lanes) {
        const Lanes3 normal = unpacked(load_packed(triangle_rows + t));
        const Lanes3 u = relative_velocity(groups, t, velocities, mean_wind, air_velocities);
        const Lanes through = dot(u, normal), squared_speed = dot(u, u);
        const Lanes squared = hn::Mul(squared_speed, dot(normal, normal));
        const Lanes product = hn::Sqrt(squared);  // |u| |N|
        const Lanes lift_per_product =
            hn::IfThenElseZero(hn::Gt(squared, set(1e-36f)), hn::Div(lift, product));
        const Lanes pressure = hn::Mul(to_pressure, hn::Abs(through));
        const Lanes along = hn::NegMulAdd(lift_per_product, hn::Abs(through), drag);
        const Lanes across = hn::CopySignToAbs(hn::Mul(lift_per_product, squared_speed), through);
        const Lanes3 force = pressure * mul_add(across, normal, along * u);
        store_packed(packed(force, hn::Mul(to_slope, product)), triangle_rows + t);
    }
}

void sums_of(const TriangleGroups& groups, const BlockRange& range, const Vec4* triangle_rows,
             Vec4* particle_rows) {
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes)
        store_packed(sum_over_triangles(groups, i, triangle_rows), particle_rows + i);
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // what does not depend on the machine
namespace weft {

HWY_EXPORT(air_forces_of);
HWY_EXPORT(sums_of);

void compute_air_forces(Parallel& parallel, const TriangleGroups& groups, std::span<const Vec4> velocities,
                        const Wind& wind, std::span<const Vec4> air_velocities, std::span<Vec4> triangle_rows,
                        std::span<Vec4> particle_forces) {
    parallel.ranges(groups.rows, [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(air_forces_of)
        (groups, range, wind, velocities.data(), air_velocities, triangle_rows.data());
    });
    parallel.ranges(groups.particles, [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(sums_of)(groups, range, triangle_rows.data(), particle_forces.data());
    });
}

}  // namespace weft
#endif
