#pragma once
// The triangles of a hierarchy's leaves, laid out for registers, with planes that bound how near each may be.

#include <array>
#include <cstdint>
#include <span>

#include "weft/types.h"

namespace weft {

using Corners = std::array<std::uint32_t, 3>;

/// Up to sixteen triangles: component by component, a triangle to a lane.
struct alignas(64) TriangleLeaf {
    static constexpr std::uint32_t size = 16;
    using Row = std::array<float, size>;
    using Row3 = std::array<Row, 3>;

    std::array<Row3, 3> corners;  ///< [m]; infinite in lanes without a triangle
    Row3 normal;                  ///< of unit length; zero if the triangle is too narrow to have planes
    std::array<Row3, 3> out;      ///< in the triangle's plane, across the edge from each corner to the next
    Row beyond;                   ///< distance of the second edge's line from the first corner [m]
    Row slack;                    ///< rounding of distances from planes, for points beside the triangle [m]
};

/// Lays the triangles out, and finds their normals and the sums of these at vertices, weighted by angles.
void fit_leaves(std::span<const Vec3> vertices, std::span<const Corners> triangles,
                std::span<TriangleLeaf> leaves, std::span<Vec3> face_normals, std::span<Vec3> vertex_normals);

}  // namespace weft
