#pragma once
// Cuts and tears: finds the edges along which a mesh separates, and separates it. See World::recut_cloth.
//
//     weft::CutStroke stroke;                                       // for as long as the blade is drawn
//     auto edges = weft::edges_along(mesh, positions, blade, stroke);
//     auto cut = weft::cut_mesh(mesh, *edges);
//     if (world.recut_cloth(cloth, cut->mesh, cut->from)) mesh = std::move(cut->mesh);
//
// Cloth separates along the edges of its triangles, none of which is divided: a cut is as straight as the
// mesh is fine. Only the particles that separate add to their number.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "weft/error.h"
#include "weft/export.h"
#include "weft/mesh.h"
#include "weft/types.h"

namespace weft {

/// The vertices at an edge's ends, in either order. At a seam, any vertex of the particle will do.
using MeshEdge = std::array<std::uint32_t, 2>;

/// A mesh that was cut.
struct MeshCut {
    Mesh mesh;
    /// For each vertex of the mesh, the vertex of the old mesh that it comes from. Old vertices keep their
    /// numbers; added ones follow.
    std::vector<std::uint32_t> from;
    std::uint32_t added_particles = 0;  ///< 0: nothing separated, and the mesh is as it was
};

/// Separates the triangles at both sides of these edges. A particle at an end of one of them becomes as many
/// as it has fans of triangles that still hang together there. So the ends of a cut within the cloth stay
/// closed, a single edge within it does not open, and edges from border to border separate the pieces.
///
/// Each triangle keeps its rest shape, so that mass and area stay. The new mesh has `welds`, and is no grid
/// any more if anything separated. It lacks the triangles that cooking would leave out, and has turned those
/// that cooking would turn. Errors: what cooking refuses, by the same words; two vertices that no edge joins.
[[nodiscard]] WEFT_API Result<MeshCut> cut_mesh(const Mesh& mesh, std::span<const MeshEdge> edges);

/// A straight blade: its two ends where it was, and where it is now [m]. The swept surface is best flat: a
/// pointer that is drawn over a picture has both ends `a` at the eye.
struct Blade {
    Vec3 was_a, was_b, is_a, is_b;
};

/// State of a stroke between calls of edges_along(). Each stroke has its own. It belongs to one mesh, of
/// which cooking leaves nothing out, and to the meshes that are cut from it meanwhile.
class CutStroke {
  public:
    /// An edge, or a point of entry, by corners of a triangle: cuts do not renumber triangles.
    struct Corners {
        std::uint32_t triangle;
        std::uint8_t first, second;
        friend bool operator==(const Corners&, const Corners&) = default;
    };
    std::vector<Corners> edges;  ///< edges that the stroke passed
    std::vector<Corners> ends;   ///< triangles in which the stroke ends, each by one corner
};

/// Returns the edges along a blade's path. Each call extends the stroke by one `blade`, which begins where
/// the last one ended. Where the blade crosses an edge, the cut goes through the nearer end, so that the
/// edges are connected, and reach the border where the blade does. All edges of the stroke are returned,
/// since earlier ones may separate only with later ones; none if this blade adds nothing. `positions` are the
/// vertices' present positions [m]. Errors: another number of positions than of vertices, a vertex out of
/// range, a blade that is not finite.
[[nodiscard]] WEFT_API Result<std::vector<MeshEdge>> edges_along(const Mesh& mesh,
                                                                 std::span<const Vec3> positions,
                                                                 const Blade& blade, CutStroke& stroke);

/// An edge that is stretched.
struct StrainedEdge {
    std::uint32_t a = 0, b = 0;  ///< vertices at its ends
    float strain = 0;            ///< length over rest length, less 1
    friend bool operator==(const StrainedEdge&, const StrainedEdge&) = default;
};

/// Returns the edges along which cloth tears that is pulled along `strained`: edges across the pull at one
/// end of each, preferably an end at a border or a cut, from where tears run on. If none is at a border, only
/// the first one opens. Pass the few most strained of World::strained_edges(); after a tear, others are
/// strained most. Errors: as edges_along(), and as cut_mesh().
[[nodiscard]] WEFT_API Result<std::vector<MeshEdge>> edges_to_tear(const Mesh& mesh,
                                                                   std::span<const Vec3> positions,
                                                                   std::span<const StrainedEdge> strained);

}  // namespace weft
