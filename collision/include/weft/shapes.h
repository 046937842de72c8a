#pragma once
// Shapes that a World holds once, and of which colliders are placed instances: props, terrain and bodies.

#include <array>
#include <cstdint>
#include <span>
#include <variant>

#include "weft/types.h"

namespace weft {

/// A generation-checked id; all-zero is null.
struct ShapeId {
    std::uint32_t index = 0, generation = 0;
    friend bool operator==(ShapeId, ShapeId) = default;
};

/// A triangle mesh. The nearest triangle, edge or vertex decides on which side of a closed mesh a point is.
/// Vertices at the same position count as one. Coordinates from -1e5 to 1e5 m, at most 2^22 triangles.
struct TriangleMesh {
    std::span<const Vec3> vertices{};  ///< [m]
    /// Counter-clockwise seen from outside.
    std::span<const std::array<std::uint32_t, 3>> triangles{};
    /// A closed mesh is solid inside, and each edge must have two triangles. An open one is a sheet with two
    /// sides, and keeps cloth on the side from which it came.
    bool closed = true;
};

/// The least convex solid around points; those within it are dropped. Error: all points lie within a
/// thousandth of a millimetre and a millionth of their extent of a plane.
struct ConvexHull {
    std::span<const Vec3> points{};  ///< [m], at least 4, at most 2^16
};

/// Ground, solid below: the vertex of row r and column c is at (c spacing, heights[r columns + c],
/// r spacing). Cells are cut from (r, c) to (r + 1, c + 1). Beyond its border there is nothing.
struct HeightField {
    std::uint32_t rows = 0, columns = 0;  ///< each at least 2; together at most 2^24 vertices
    float spacing = 1;                    ///< [m], from 1e-4 to 1e4
    std::span<const float> heights{};     ///< [m], each from -1e5 to 1e5
};

/// Distances from a closed mesh at the corners of cells, interpolated trilinearly: as fast for a million
/// triangles as for ten. The error is at most 0.87 of a cell, the greatest distance of a point from corners,
/// and far less on faces; sharp edges are rounded by up to half a cell.
struct DistanceField {
    TriangleMesh mesh{};  ///< read while the shape is made; not kept
    float cell = 0.02f;   ///< [m], at least a 512th of the mesh's longest side, for at most 2^24 corners
};

using Shape = std::variant<TriangleMesh, ConvexHull, HeightField, DistanceField>;

/// Size and accuracy of a shape that the World has made.
struct ShapeInfo {
    std::uint32_t triangles = 0;  ///< of a mesh, a hull or a height field
    Bounds bounds{};              ///< bounding box in its local frame [m]
    float error = 0;              ///< greatest error of distances [m], but for rounding
    std::uint64_t bytes = 0;
};

}  // namespace weft
