#pragma once
// Operations on garments' meshes: placement, refinement, patterns, openings and normals.

#include <cstdint>
#include <vector>

#include "engine/vector.h"
#include "weft/mesh.h"

namespace weft::demo {

/// Turns a garment from +Z up, as most garment files are, to +Y up; puts its middle over the origin and its
/// lowest point at `lowest` [m].
void stand_upright(Mesh& mesh, float lowest);

/// Cuts every triangle in four at the middles of its edges, in space and on the pattern.
[[nodiscard]] Mesh refined(const Mesh& mesh);

/// For each vertex of one mesh, the vertex of another that is nearest to it.
[[nodiscard]] std::vector<std::uint32_t> nearest_vertices(const Mesh& to, const Mesh& of);

/// Length of an edge at rest [m]: in the pattern, where the mesh has one.
[[nodiscard]] float rest_length(const Mesh& mesh, std::uint32_t a, std::uint32_t b);

/// Drops a pattern that is not in metres: one whose edges are, on the whole, not as long as the garment's
/// own.
void drop_unfit_pattern(Mesh& mesh);

/// Metres in a unit of the file that the mesh is from: 1, a centimetre, a millimetre or an inch, the first by
/// which it has a garment's size, from 0.2 m to 3 m. If none does: that by which its longest side is 1 m.
[[nodiscard]] float guessed_unit(const Mesh& mesh);

/// The vertices around the highest opening (by mean height), one for each position: a neck, or a waist. An
/// open sheet, and a mesh without openings, give topmost().
[[nodiscard]] std::vector<std::uint32_t> highest_opening(const Mesh& mesh);

/// Vertices within the topmost fiftieth of the mesh's height; of a mesh that lies flat, of its length.
[[nodiscard]] std::vector<std::uint32_t> topmost(const Mesh& mesh);

/// Vertices of border edges (edges of one triangle), one for each position; topmost() where there are none.
[[nodiscard]] std::vector<std::uint32_t> border_vertices(const Mesh& mesh);

/// Number of loops of border edges: a skirt has two, a shirt four.
[[nodiscard]] std::size_t count_openings(const Mesh& mesh);

/// Unit normals of all vertices, on the whole away from the mesh's middle; +Y for vertices without triangles.
[[nodiscard]] std::vector<Vector3> outward_normals(const Mesh& mesh);

}  // namespace weft::demo
