#pragma once
// Solids of triangles, for colliders and for drawing: counter-clockwise seen from outside.

#include <cstdint>
#include <span>

#include "weft/mesh.h"
#include "weft/shapes.h"

namespace weft::demo {

/// A profile of {distance from the axis, height} [m], upwards on its outer side, turned about +Y in `parts`
/// parts. `closed`: its end is joined to its beginning, as a tube's; otherwise both lie on the axis.
[[nodiscard]] Mesh turned(std::span<const Vec2> profile, std::uint32_t parts, bool closed);
[[nodiscard]] Mesh torus(float radius, float tube, std::uint32_t around, std::uint32_t across);
/// A stone of 20 faces, which share no vertices, within `radius`.
[[nodiscard]] Mesh stone(const Vec3& radius);
/// The surface of a height field, in its own space.
[[nodiscard]] Mesh surface_of(const HeightField& field);

/// Unit normals, by area over the triangles about each vertex.
[[nodiscard]] std::vector<Vec4> vertex_normals(const Mesh& mesh);

}  // namespace weft::demo
