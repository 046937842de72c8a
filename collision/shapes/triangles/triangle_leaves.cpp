#include "collision/shapes/triangles/triangle_leaves.h"

#include <algorithm>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/shapes/triangles/triangle_leaves.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "collision/geometry/closest-inl.h"
#include "hwy/contrib/math/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

HWY_INLINE Lanes3 load_rows3(const TriangleLeaf::Row3& rows, std::uint32_t lane) {
    return {load_lanes(&rows[0][lane]), load_lanes(&rows[1][lane]), load_lanes(&rows[2][lane])};
}
HWY_INLINE void store_rows3(const Lanes3& v, TriangleLeaf::Row3& rows, std::uint32_t lane) {
    hn::Store(v.x, Tag(), &rows[0][lane]);
    hn::Store(v.y, Tag(), &rows[1][lane]);
    hn::Store(v.z, Tag(), &rows[2][lane]);
}

/// The vector over its greatest component first, so that squares neither overflow nor vanish.
HWY_INLINE Lanes3 safe_unit(const Lanes3& v) {
    const Lanes most = hn::Max(hn::Abs(v.x), hn::Max(hn::Abs(v.y), hn::Abs(v.z)));
    return unit(hn::Div(set(1), hn::Max(most, set(1e-30f))) * v);
}

HWY_INLINE Lanes angle_between(const Lanes3& a, const Lanes3& b) {
    const Lanes3 u = safe_unit(a), v = safe_unit(b);
    return hn::Acos(Tag(), hn::Max(hn::Min(dot(u, v), set(1)), set(-1)));
}

/// Planes and angles of a part of a leaf. Rounding turns a narrow triangle's planes by about its length over
/// its height, in units of 1e-6.
void find_planes(TriangleLeaf& leaf, std::uint32_t lane, TriangleLeaf::Row3& faces,
                 TriangleLeaf::Row3& angles) {
    constexpr float rounding = 4e-6f, most_narrow = 20;
    const Lanes3 a = load_rows3(leaf.corners[0], lane), b = load_rows3(leaf.corners[1], lane),
                 c = load_rows3(leaf.corners[2], lane);
    const Lanes3 ab = b - a, bc = c - b, ca = a - c, back = zero3();
    const Lanes longest = hn::Sqrt(hn::Max(dot(ab, ab), hn::Max(dot(bc, bc), dot(ca, ca))));
    const Lanes per_longest = hn::Div(set(1), hn::Max(longest, set(1e-30f)));
    const Lanes3 across = cross(per_longest * ab, per_longest * (back - ca)), normal = safe_unit(across);
    const Lanes height = hn::Sqrt(dot(across, across));  // over the longest edge
    const auto has_planes = hn::Gt(hn::Mul(set(most_narrow), height), set(1));
    store_rows3(normal, faces, lane);
    store_rows3(keep_where(has_planes, normal), leaf.normal, lane);
    const auto outward = [&](const Lanes3& edge)
                             HWY_ATTR { return keep_where(has_planes, safe_unit(cross(edge, normal))); };
    const Lanes3 of_bc = outward(bc);
    store_rows3(outward(ab), leaf.out[0], lane);
    store_rows3(of_bc, leaf.out[1], lane);
    store_rows3(outward(ca), leaf.out[2], lane);
    hn::Store(dot(of_bc, ab), Tag(), &leaf.beyond[lane]);
    const Lanes slack = hn::Mul(set(rounding), hn::Div(longest, hn::Max(height, set(1e-30f))));
    hn::Store(hn::IfThenElseZero(has_planes, slack), Tag(), &leaf.slack[lane]);
    hn::Store(angle_between(ab, back - ca), Tag(), &angles[0][lane]);
    hn::Store(angle_between(bc, back - ab), Tag(), &angles[1][lane]);
    hn::Store(angle_between(ca, back - bc), Tag(), &angles[2][lane]);
}

void fit_all_leaves(std::span<const Vec3> vertices, std::span<const Corners> triangles,
                    std::span<TriangleLeaf> leaves, std::span<Vec3> face_normals,
                    std::span<Vec3> vertex_normals) {
    std::ranges::fill(vertex_normals, Vec3{});
    for (std::size_t n = 0; n < leaves.size(); ++n) {
        TriangleLeaf& leaf = leaves[n];
        const std::size_t first = n * TriangleLeaf::size;
        const std::size_t count = std::min<std::size_t>(TriangleLeaf::size, triangles.size() - first);
        if (count < TriangleLeaf::size)
            for (TriangleLeaf::Row3& rows : leaf.corners)
                for (TriangleLeaf::Row& row : rows) row.fill(std::numeric_limits<float>::infinity());
        for (std::size_t t = 0; t < count; ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3& corner = vertices[triangles[first + t][k]];
                leaf.corners[k][0][t] = corner.x;
                leaf.corners[k][1][t] = corner.y;
                leaf.corners[k][2][t] = corner.z;
            }
        alignas(64) TriangleLeaf::Row3 faces, angles;
        for (std::uint32_t lane = 0; lane < TriangleLeaf::size; lane += part_lanes)
            find_planes(leaf, lane, faces, angles);
        for (std::size_t t = 0; t < count; ++t) {
            const Vec3 face{faces[0][t], faces[1][t], faces[2][t]};
            face_normals[first + t] = face;
            for (std::size_t k = 0; k < 3; ++k) {
                const float angle = angles[k][t];
                Vec3& sum = vertex_normals[triangles[first + t][k]];
                sum = {sum.x + angle * face.x, sum.y + angle * face.y, sum.z + angle * face.z};
            }
        }
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace weft {

HWY_EXPORT(fit_all_leaves);

void fit_leaves(std::span<const Vec3> vertices, std::span<const Corners> triangles,
                std::span<TriangleLeaf> leaves, std::span<Vec3> face_normals,
                std::span<Vec3> vertex_normals) {
    HWY_DYNAMIC_DISPATCH(fit_all_leaves)(vertices, triangles, leaves, face_normals, vertex_normals);
}

}  // namespace weft
#endif
