#pragma once
// Solids of triangles, counter-clockwise seen from outside, for colliders and for drawing; and holders of
// cloth.

#include <cstdint>
#include <span>

#include "weft/mesh.h"
#include "weft/shapes.h"
#include "weft/world.h"

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

/// Holders of cloth are only drawn: they take no part in the simulation.
struct Annotation;

enum class Holder {
    rod,    ///< through the first and the last vertex, a bit longer
    hands,  ///< at each vertex
    posts   ///< from the ground to each vertex
};

/// Draws a holder of these vertices, those of them that are pinned.
void draw_holder(const ClothView& cloth, std::span<const std::uint32_t> vertices, Holder holder,
                 Annotation& to);

/// Draws a level grate of 1 m by 0.8 m, whose lower side is at that height [m].
void draw_grate(float height, Annotation& to);

}  // namespace weft::demo
