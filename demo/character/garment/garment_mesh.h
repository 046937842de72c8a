#pragma once
// Garments as files hold them, made ready to hang.

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

/// Drops a pattern that is not in metres: one whose edges are, on the whole, not as long as the garment's
/// own.
void drop_unfit_pattern(Mesh& mesh);

/// The vertices around the highest opening (by mean height), one for each position: a neck, or a waist. Those
/// of the topmost fiftieth where the mesh has no opening.
[[nodiscard]] std::vector<std::uint32_t> highest_opening(const Mesh& mesh);

/// Vertices of the topmost fiftieth.
[[nodiscard]] std::vector<std::uint32_t> topmost(const Mesh& mesh);

/// Vertices of edges of one triangle, one for each position; the topmost where there are none.
[[nodiscard]] std::vector<std::uint32_t> border_vertices(const Mesh& mesh);

/// Closed rows of border edges: a skirt has two, a shirt four.
[[nodiscard]] std::size_t count_openings(const Mesh& mesh);

/// Out of the front of a garment that is round something, by vertex; up, where a vertex has no triangles.
[[nodiscard]] std::vector<Vector3> outward_normals(const Mesh& mesh);

}  // namespace weft::demo
