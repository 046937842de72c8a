#pragma once
// Shapes that a World holds once, of which colliders are placed instances: what props, terrain and bodies are
// made of.

#include <array>
#include <cstdint>
#include <span>
#include <variant>

#include "weft/types.h"

namespace weft {

/// Generation-checked; all-zero is null.
struct ShapeId {
    std::uint32_t index = 0, generation = 0;
    friend bool operator==(ShapeId, ShapeId) = default;
};

/// Triangles as they are. Which side of a closed mesh a point is on follows from the nearest triangle, edge
/// or vertex. Vertices at the same position count as one. Coordinates from -1e5 to 1e5 m, at most 2^22
/// triangles.
struct TriangleMesh {
    std::span<const Vec3> vertices{};  ///< [m]
    /// Counter-clockwise seen from outside.
    std::span<const std::array<std::uint32_t, 3>> triangles{};
    /// Its inside is solid. Every edge is to have two triangles then. Else it is a sheet with two sides, and
    /// keeps cloth on that on which it came.
    bool closed = true;
};

/// The least convex solid around points; those within it are dropped. Error: all of them within a thousandth
/// of a millimetre and a millionth of their extent of a plane.
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

/// Distances from a closed mesh at the corners of cells, trilinear between them: as fast for a million
/// triangles as for ten. Nowhere wrong by more than 0.87 of a cell, the farthest that a point is from
/// corners, and on faces by far less; sharp edges are rounded by up to half a cell.
struct DistanceField {
    TriangleMesh mesh{};  ///< it is not kept
    float cell = 0.02f;   ///< [m], at least a 512th of the mesh's longest side, for at most 2^24 corners
};

using Shape = std::variant<TriangleMesh, ConvexHull, HeightField, DistanceField>;

/// What the World made of one.
struct ShapeInfo {
    std::uint32_t triangles = 0;  ///< of a mesh, a hull or a height field
    Bounds bounds{};              ///< in its own space [m]
    float error = 0;              ///< of distances at most [m], but for rounding
    std::uint64_t bytes = 0;
};

}  // namespace weft
