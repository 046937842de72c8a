#include "cloth/normals.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/normals.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/triangle_groups-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// 0 for equal a and b: each product is rounded.
HWY_INLINE Lanes3 cross(const Lanes3& a, const Lanes3& b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

void area_normals_of(const TriangleGroups& groups, const BlockRange& range, const Vec4* positions,
                     Vec4* area_normals) {
    for (std::uint32_t t = range.begin; t < range.end; t += part_lanes) {
        const PackedRows a = corner_rows(groups, t, 0, positions);
        const Lanes3 to_b = unpacked(corner_rows(groups, t, 1, positions) - a),
                     to_c = unpacked(corner_rows(groups, t, 2, positions) - a);
        store_packed(packed(cross(to_b, to_c), hn::Zero(Tag())), area_normals + t);
    }
}

void normals_of(const TriangleGroups& groups, const BlockRange& range, const Vec4* area_normals,
                Vec4* normals) {
    const Lanes zero = hn::Zero(Tag()), one = hn::Set(Tag(), 1.0f);
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const Lanes3 sum = unpacked(sum_over_triangles(groups, i, area_normals));
        const Lanes squared = dot(sum, sum);
        const auto has_direction = hn::Gt(squared, hn::Set(Tag(), 1e-36f));
        const Lanes3 n = hn::Div(one, hn::Sqrt(squared)) * sum;
        store_packed(packed({hn::IfThenElseZero(has_direction, n.x), hn::IfThenElse(has_direction, n.y, one),
                             hn::IfThenElseZero(has_direction, n.z)},
                            zero),
                     normals + i);
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // what does not depend on the machine
namespace weft {

HWY_EXPORT(area_normals_of);
HWY_EXPORT(normals_of);

void compute_area_normals(Parallel& parallel, const TriangleGroups& groups, std::span<const Vec4> positions,
                          std::span<Vec4> area_normals) {
    parallel.ranges(groups.rows, [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(area_normals_of)(groups, range, positions.data(), area_normals.data());
    });
}

void compute_normals(Parallel& parallel, const TriangleGroups& groups, std::span<const Vec4> area_normals,
                     std::span<Vec4> normals) {
    parallel.ranges(groups.particles, [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(normals_of)(groups, range, area_normals.data(), normals.data());
        // What lies behind the last particle stays 0.
        for (std::uint32_t i = range.end; i % TriangleGroups::lanes != 0; ++i) normals.data()[i] = {};
    });
}

}  // namespace weft
#endif
