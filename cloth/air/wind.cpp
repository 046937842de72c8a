#include "cloth/air/wind.h"

#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/air/wind.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/surface/grid_cells-inl.h"
#include "cloth/surface/triangle_groups-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

HWY_INLINE PackedRows sum_over_corners(const TriangleGroups& groups, std::uint32_t t, const Vec4* rows) {
    return corner_rows(groups, t, 0, rows) + corner_rows(groups, t, 1, rows) +
           corner_rows(groups, t, 2, rows);
}

/// The air's velocity minus the triangles', thrice [m/s].
HWY_INLINE Lanes3 relative_velocities(const TriangleGroups& groups, std::uint32_t t, const Vec4* velocities,
                                      const Lanes3& mean_wind, std::span<const Vec4> air_velocities) {
    const PackedRows sum = sum_over_corners(groups, t, velocities);
    if (air_velocities.empty()) return set(3) * mean_wind - unpacked(sum);
    return unpacked(sum_over_corners(groups, t, air_velocities.data()) - sum);
}

// With u the relative velocity, n the normal on the side to which the air streams and c = u.n / |u| >= 0:
//   drag  = 1/2 rho A c |u| Cd u               along the stream, by the area that faces it
//   lift  = 1/2 rho A c |u| Cl (|u| n - c u)   across it, greatest at 45 degrees, none head-on or edge-on
// (the flat-plate model of Keckeisen et al. 2004, "Modelling effects of wind fields in cloth animations",
// with lift that vanishes edge-on, so that the force is continuous where the side that faces the wind
// changes). With N = 2 A n:
//   c = |u.N| / (|u| |N|),   |u| n = sign(u.N) |u|^2 / (|u| |N|) N
// Here 3 u, the sum over the corners, stands for u.
struct AirOnPlates {
    explicit AirOnPlates(const ClothInAir& cloth)
        : drag(cloth.drag_scale * cloth.wind->drag),
          lift(cloth.lift_scale * cloth.wind->lift),
          to_pressure(cloth.wind->air_density / 12 / 9),  // rho A / 6, from 2 A and two factors 3 u
          to_slope(cloth.wind->air_density / 6 / 3 * (drag + lift)) {}

    /// A third of the force on triangles; w is its slope.
    HWY_INLINE Lanes4 thirds(const Lanes3& normal, const Lanes3& u) const {
        const Lanes through = dot(u, normal), squared_speed = dot(u, u);
        const Lanes squared = hn::Mul(squared_speed, dot(normal, normal));
        const Lanes product = hn::Sqrt(squared);  // |u| |N|
        const Lanes lift_per_product =
            hn::IfThenElseZero(hn::Gt(squared, set(1e-36f)), hn::Div(set(lift), product));
        const Lanes pressure = hn::Mul(set(to_pressure), hn::Abs(through));
        const Lanes along = hn::NegMulAdd(lift_per_product, hn::Abs(through), set(drag));
        const Lanes across = hn::CopySignToAbs(hn::Mul(lift_per_product, squared_speed), through);
        const Lanes3 force = pressure * mul_add(across, normal, along * u);
        return {force.x, force.y, force.z, hn::Mul(set(to_slope), product)};
    }

    float drag, lift, to_pressure, to_slope;
};

HWY_INLINE Lanes3 mean_wind_on(const ClothInAir& cloth) {
    const Vector3 wind = cloth.mean_wind();
    return {set(wind.x()), set(wind.y()), set(wind.z())};
}

void air_forces_of(const TriangleGroups& groups, const BlockRange& range, const ClothInAir& cloth,
                   Vec4* triangle_rows) {
    const AirOnPlates air(cloth);
    const Lanes3 mean_wind = mean_wind_on(cloth);
    for (std::uint32_t t = range.begin; t < range.end; t += part_lanes) {
        const Lanes3 normal = unpacked(load_packed(triangle_rows + t));
        const Lanes4 force = air.thirds(
            normal, relative_velocities(groups, t, cloth.velocities.data(), mean_wind, cloth.air_velocities));
        store_packed(packed(xyz(force), force.w), triangle_rows + t);
    }
}

/// The force at from_velocities on particles from `i` on, along its slope, of that at their velocities.
HWY_INLINE Lanes3 along_slope(const ClothInAir& cloth, std::uint32_t i, const Lanes3& force, Lanes slope) {
    const Lanes3 since = xyz(load_rows(&cloth.velocities[i])) - xyz(load_rows(&cloth.from_velocities[i]));
    return mul_add(slope, since, force);
}
HWY_INLINE Lanes along_slope(Lanes rows, Lanes since) {
    return hn::MulAdd(hn::Broadcast<3>(rows), since, rows);
}
/// The same for rows of forces and slopes. Precondition: w of velocities is 0.
HWY_INLINE PackedRows along_slope(const ClothInAir& cloth, std::uint32_t i, const PackedRows& rows) {
    const PackedRows since = load_packed(&cloth.velocities[i]) - load_packed(&cloth.from_velocities[i]);
    return {along_slope(rows.r0, since.r0), along_slope(rows.r1, since.r1), along_slope(rows.r2, since.r2),
            along_slope(rows.r3, since.r3)};
}

void air_forces_of_grid(const GridCells& cells, const BlockRange& tile, const GridWindow& window,
                        const ClothInAir& cloth, Vec4* forces) {
    const AirOnPlates air(cloth);
    const Lanes3 mean_wind = mean_wind_on(cloth);
    const Vec4 *const positions = cloth.positions.data(), *const velocities = cloth.velocities.data();
    const std::span<const Vec4> air_velocities = cloth.air_velocities;
    CellLoop<2, 4> loop(cells, tile, window);
    for (std::uint32_t i = loop.first(); i < tile.end; i += part_lanes, loop.go_on()) {
        loop.read_ahead([&](std::uint32_t j) HWY_ATTR {
            const Lanes3 streams =
                air_velocities.empty() ? mean_wind : xyz(load_rows(air_velocities.data() + j));
            return std::array<Lanes3, 2>{xyz(load_rows(positions + j)),
                                         streams - xyz(load_rows(velocities + j))};
        });
        const CellLanes cell(cells, i);
        const Corners u = loop.corners(1);
        const auto [left_normal, right_normal] = cell.area_normals(loop.corners(0));
        const Lanes4 left = air.thirds(left_normal, u.first + u.far_left + cell.third_of_left(u));
        const Lanes4 right = air.thirds(right_normal, u.far_right + u.near_right + cell.third_of_right(u));
        const auto [x, y, z, slope] = loop.sums({cell.shares(left.x, right.x), cell.shares(left.y, right.y),
                                                 cell.shares(left.z, right.z), cell.shares(left.w, right.w)});
        if (i >= tile.begin) store_rows(along_slope(cloth, i, {x, y, z}, slope), slope, forces + i);
    }
}

void sums_of(const TriangleGroups& groups, const BlockRange& range, const ClothInAir& cloth,
             const Vec4* triangle_rows, Vec4* particle_rows) {
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes)
        store_packed(along_slope(cloth, i, sum_over_triangles(groups, i, triangle_rows)), particle_rows + i);
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // compiled once, not for each instruction set
namespace weft {

HWY_EXPORT(air_forces_of);
HWY_EXPORT(air_forces_of_grid);
HWY_EXPORT(sums_of);

void compute_air_forces(Parallel& parallel, const TriangleGroups& groups, const ClothInAir& cloth,
                        std::span<Vec4> triangle_rows, std::span<Vec4> particle_forces) {
    parallel.ranges(groups.rows, [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(air_forces_of)(groups, range, cloth, triangle_rows.data());
    });
    parallel.ranges(groups.particles, [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(sums_of)(groups, range, cloth, triangle_rows.data(), particle_forces.data());
    });
}

void compute_air_forces(Parallel& parallel, GridCells& cells, const ClothInAir& cloth,
                        std::span<Vec4> particle_forces) {
    in_tiles(parallel, cells.diagonals.nodes, cells.windows(),
             [&](const BlockRange& tile, const GridWindow& window) {
                 HWY_DYNAMIC_DISPATCH(air_forces_of_grid)
                 (cells, tile, window, cloth, particle_forces.data());
             });
}

}  // namespace weft
#endif
