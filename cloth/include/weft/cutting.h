#pragma once
// Cuts and tears: which edges of a mesh are to part, and the mesh once they have. See World::recut_cloth.
//
//     weft::CutStroke stroke;                                       // for as long as the blade is drawn
//     auto edges = weft::edges_along(mesh, positions, blade, stroke);
//     auto cut = weft::cut_mesh(mesh, *edges);
//     if (world.recut_cloth(cloth, cut->mesh, cut->from)) mesh = std::move(cut->mesh);
//
// Cloth parts along the edges of its triangles, none of which is divided: a cut is as straight as the mesh is
// fine. Particles stay as many as they were but for those that part.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "weft/error.h"
#include "weft/export.h"
#include "weft/mesh.h"
#include "weft/types.h"

namespace weft {

/// The vertices at an edge's ends, in either order. At a seam it does not matter which of several that are
/// one particle.
using MeshEdge = std::array<std::uint32_t, 2>;

/// A mesh that was cut.
struct MeshCut {
    Mesh mesh;
    /// Of each vertex of the mesh the one of the old mesh that it comes from. The old ones keep their
    /// numbers, those that were added follow.
    std::vector<std::uint32_t> from;
    std::uint32_t added_particles = 0;  ///< 0: nothing parted, and the mesh is as it was
};

/// Parts the triangles at both sides of these edges. A particle at an end of one of them becomes as many as
/// it has fans of triangles that still hang together there: so ends of a cut within the cloth stay whole, a
/// single edge within it does not open, and edges from border to border take the parts off each other.
///
/// Each triangle keeps its rest shape, so that mass and area stay. The new mesh has `welds`, and is no grid
/// any more where anything parted; it has no triangles that cooking would leave out, and those it would turn
/// are turned. Errors: what cooking refuses, by the same words; two vertices that no edge joins.
[[nodiscard]] WEFT_API Result<MeshCut> cut_mesh(const Mesh& mesh, std::span<const MeshEdge> edges);

/// A straight blade: its two ends where it was, and where it is now [m]. Best flat: a pointer that is drawn
/// over a picture has both ends `a` at the eye.
struct Blade {
    Vec3 was_a, was_b, is_a, is_b;
};

/// What edges_along() knows of a blade's way so far: one for each stroke, and for one mesh of which cooking
/// leaves nothing out, and those that are cut from it meanwhile.
class CutStroke {
  public:
    /// Corners of a triangle, which cuts do not number anew.
    struct Corners {
        std::uint32_t triangle;
        std::uint8_t first, second;
        friend bool operator==(const Corners&, const Corners&) = default;
    };
    std::vector<Corners> edges;  ///< along which it went
    std::vector<Corners> ends;   ///< of triangles into which it went, and has not come out
};

/// Edges along the way of a blade, drawn on by one `blade` after the other, each beginning where the last one
/// ended: where it crosses an edge the cut goes through the nearer end. So the edges hang together, and reach
/// the border where the blade does. All of the stroke, since what it passed may part only with what follows;
/// none if this blade adds nothing. `positions` are where the mesh's vertices are now [m]. Errors: another
/// number of positions than of vertices, a vertex out of range, a blade that is not finite.
[[nodiscard]] WEFT_API Result<std::vector<MeshEdge>> edges_along(const Mesh& mesh,
                                                                 std::span<const Vec3> positions,
                                                                 const Blade& blade, CutStroke& stroke);

/// An edge that is stretched.
struct StrainedEdge {
    std::uint32_t a = 0, b = 0;  ///< vertices at its ends
    float strain = 0;            ///< its length over that at rest, less 1
    friend bool operator==(const StrainedEdge&, const StrainedEdge&) = default;
};

/// Edges along which cloth gives way that is pulled along these: at one end of each, across the pull, at that
/// of a border or of a cut if there is one, since there tears run on. Give the few of
/// World::strained_edges() that are strained most; once what they hold has parted, others are. Errors: as
/// edges_along(), and as cut_mesh().
[[nodiscard]] WEFT_API Result<std::vector<MeshEdge>> edges_to_tear(const Mesh& mesh,
                                                                   std::span<const Vec3> positions,
                                                                   std::span<const StrainedEdge> strained);

}  // namespace weft
