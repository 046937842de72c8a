#pragma once
// A surface without anything else, and what prepares a fine mesh for its cells.

#include <cstdint>
#include <vector>

#include "cloth/surface/nearest_triangle.h"
#include "engine/vector.h"
#include "weft/error.h"
#include "weft/mesh.h"

namespace weft {

/// Edges have one triangle or two.
struct PlainSurface {
    std::vector<Vector3> points;  ///< [m]
    std::vector<Triangle> triangles;
};

/// The surface as cooking has it: welded, and with at most two triangles at an edge.
[[nodiscard]] Result<PlainSurface> plain_surface(const Mesh& mesh);
/// A search among its triangles.
[[nodiscard]] NearestTriangle nearest_on(const PlainSurface& surface);
/// The triangles with a true in `kept`, with their points in the same order.
[[nodiscard]] PlainSurface kept_of(const PlainSurface& surface, const std::vector<bool>& kept);

[[nodiscard]] float area_of(const PlainSurface& surface, const Triangle& triangle);

/// The number of each triangle's part, from 0 in the order of first triangles. Triangles with a common edge
/// are of one part if both are `joined`.
[[nodiscard]] std::vector<std::uint32_t> parts_of(const PlainSurface& surface,
                                                  const std::vector<bool>& joined);

/// Borders as closed loops of points, each in the direction of the triangles that it borders.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> borders_of(const PlainSurface& surface);
[[nodiscard]] float length_of(const PlainSurface& surface, const std::vector<std::uint32_t>& loop);

/// Returns true for each triangle that stays when of two layers that face away from each other, no more than
/// `thickness` apart [m], only the larger stays.
[[nodiscard]] std::vector<bool> outer_layers(const PlainSurface& surface, float thickness);

/// Closes a border by triangles to its middle.
void close_border(PlainSurface& surface, const std::vector<std::uint32_t>& loop);
/// Halves edges until none is longer than `longest` [m].
void refine(PlainSurface& surface, float longest);

}  // namespace weft
