#include "cloth/surface/normals.h"

#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/surface/normals.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/surface/grid_cells-inl.h"
#include "cloth/surface/triangle_groups-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

void area_normals_of(const TriangleGroups& groups, const BlockRange& range, const Vec4* positions,
                     Vec4* area_normals) {
    for (std::uint32_t t = range.begin; t < range.end; t += part_lanes) {
        const PackedRows a = corner_rows(groups, t, 0, positions);
        const Lanes3 to_b = unpacked(corner_rows(groups, t, 1, positions) - a),
                     to_c = unpacked(corner_rows(groups, t, 2, positions) - a);
        store_packed(packed(cross(to_b, to_c), hn::Zero(Tag())), area_normals + t);
    }
}

/// Unit normals from sums of area normals; +Y where these are 0.
HWY_INLINE Lanes3 unit_normals(const Lanes3& sum) {
    const Lanes one = hn::Set(Tag(), 1.0f), squared = dot(sum, sum);
    const auto has_direction = hn::Gt(squared, hn::Set(Tag(), 1e-36f));
    const Lanes3 n = hn::Div(one, hn::Sqrt(squared)) * sum;
    return {hn::IfThenElseZero(has_direction, n.x), hn::IfThenElse(has_direction, n.y, one),
            hn::IfThenElseZero(has_direction, n.z)};
}

void normals_of(const TriangleGroups& groups, const BlockRange& range, const Vec4* area_normals,
                Vec4* normals) {
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const Lanes3 sum = unpacked(sum_over_triangles(groups, i, area_normals));
        store_packed(packed(unit_normals(sum), hn::Zero(Tag())), normals + i);
    }
}

void normals_of_grid(const GridCells& cells, const BlockRange& tile, const GridWindow& window,
                     const Vec4* positions, Vec4* normals) {
    CellLoop<1, 3> loop(cells, tile, window);
    for (std::uint32_t i = loop.first(); i < tile.end; i += part_lanes, loop.go_on()) {
        loop.read_ahead([&](std::uint32_t j)
                            HWY_ATTR { return std::array<Lanes3, 1>{xyz(load_rows(positions + j))}; });
        const CellLanes cell(cells, i);
        const auto [left, right] = cell.area_normals(loop.corners(0));
        const auto [x, y, z] = loop.sums(
            {cell.shares(left.x, right.x), cell.shares(left.y, right.y), cell.shares(left.z, right.z)});
        if (i >= tile.begin) store_rows(unit_normals({x, y, z}), hn::Zero(Tag()), normals + i);
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // compiled once, not for each instruction set
namespace weft {

HWY_EXPORT(area_normals_of);
HWY_EXPORT(normals_of);
HWY_EXPORT(normals_of_grid);

void compute_area_normals(Parallel& parallel, const TriangleGroups& groups, std::span<const Vec4> positions,
                          std::span<Vec4> area_normals) {
    parallel.ranges(groups.rows, [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(area_normals_of)(groups, range, positions.data(), area_normals.data());
    });
}

namespace {

/// Clears the padding of the last group, behind the last particle.
void clear_behind(std::uint32_t end, std::span<Vec4> rows) {
    for (std::uint32_t i = end; i % Stencil::lanes != 0; ++i) rows.data()[i] = {};
}

}  // namespace

void compute_normals(Parallel& parallel, const TriangleGroups& groups, std::span<const Vec4> area_normals,
                     std::span<Vec4> normals) {
    parallel.ranges(groups.particles, [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(normals_of)(groups, range, area_normals.data(), normals.data());
        clear_behind(range.end, normals);
    });
}

void compute_normals(Parallel& parallel, GridCells& cells, std::span<const Vec4> positions,
                     std::span<Vec4> normals) {
    in_tiles(parallel, cells.diagonals.nodes, cells.windows(),
             [&](const BlockRange& tile, const GridWindow& window) {
                 HWY_DYNAMIC_DISPATCH(normals_of_grid)(cells, tile, window, positions.data(), normals.data());
                 clear_behind(tile.end, normals);
             });
}

}  // namespace weft
#endif
