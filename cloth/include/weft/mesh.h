#pragma once
// The triangle mesh from which a cloth is made.

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "weft/error.h"
#include "weft/export.h"
#include "weft/types.h"

namespace weft {

using Triangle = std::array<std::uint32_t, 3>;  ///< vertex indices, counter-clockwise seen from the front

/// Any triangle mesh; several components and borders are allowed. Vertices at exactly the same position are
/// welded into one particle along open edges, such as those at which a renderer split the mesh for texture
/// seams. Layers that touch elsewhere stay apart. Cooking leaves out or turns what a cloth cannot have, and
/// CookReport lists it: triangles of no area, doubled ones, a third one at an edge, parts that are wound
/// against each other.
///
/// At most 2^26 vertices and 2^27 triangles. Reading a mesh takes time and memory in proportion to its size,
/// up to a logarithm.
struct Mesh {
    std::vector<Vec3> positions{};  ///< initial positions [m], one per vertex
    std::vector<Triangle> triangles{};

    /// Optional: the flat pattern that is the rest shape, one point per vertex [m] (at a seam the two panels'
    /// vertices lie at one position in space and at two places of the pattern). Empty: the mesh itself is the
    /// rest shape.
    std::vector<Vec2> pattern{};

    /// Optional: texture coordinates, one per vertex, for renderers. The simulation does not use them.
    std::vector<Vec2> texcoords{};

    /// Set by make_sheet: vertex (row, column) is positions[row * columns + column], each cell of four is two
    /// triangles, cut along either diagonal, and springs run along the threads (structural, shear, bend). 0:
    /// a general mesh, with springs on edges, and bending in rings round particles.
    std::uint32_t rows = 0, columns = 0;

    /// Optional: for each vertex the first vertex of its particle, possibly itself; a particle's vertices lie
    /// at one position. Other vertices at that position are other particles, as along a cut (cut_mesh).
    /// Empty: vertices at the same position are welded along open edges.
    std::vector<std::uint32_t> welds{};
};

/// A rectangular sheet of particles in rows and columns.
struct SheetSettings {
    std::uint32_t rows = 64, columns = 64;  ///< particles along v and u, >= 2 each, rows * columns <= 2^26
    Vec3 origin{-0.5f, 0, -0.5f};           ///< the corner (row 0, column 0) [m]
    Vec3 u{1, 0, 0};                        ///< from that corner along a row, the whole length [m]
    Vec3 v{0, 0, 1};                        ///< from that corner along a column, the whole length [m]
};

/// Makes a sheet. Its front is the side from which u to v turns clockwise, that is, the side of v x u: up for
/// the default sheet.
[[nodiscard]] WEFT_API Result<Mesh> make_sheet(const SheetSettings& settings = {});

/// Irregularities that load_obj tolerated.
struct ObjReport {
    /// Lines of kinds that a mesh does not need: normals, groups, `vv`, `t`.
    std::uint32_t ignored_lines = 0;
    std::uint32_t triangulated_faces = 0;  ///< faces of more than three corners, cut into triangles
    /// Triangulated faces whose outline crosses itself, as a bow tie's does. No triangulation is right:
    /// triangles overlap or are turned over. Triangulate them where the mesh was made.
    std::uint32_t crossing_faces = 0;
    /// Faces whose outline visits one position twice, as it does around a hole that a doubled edge joins to
    /// it. They are triangulated correctly unless they count as crossing, too.
    std::uint32_t touching_faces = 0;
};

struct ObjOptions {
    /// Whether texture coordinates are the flat pattern in metres, too; every corner then needs one. False:
    /// they are texcoords only.
    bool texcoords_are_pattern = false;
};

/// Reads a Wavefront OBJ file. Vertex i is the file's `v` line i, used or not. Where one position has several
/// texture coordinates (seams), vertices for these follow after all of the file's own, in order of use. A
/// face of n corners becomes n - 2 triangles, which face as it does and cover it once: a fan about its first
/// corner or, beyond 64 corners, repeated halves, so that no corner gets many. If the outline is so concave
/// that one of these would be turned over, the face is cut by ears. Holes and outlines that cross themselves
/// are counted: see ObjReport. Errors name the file and the line: a missing or unreadable file, a line cut
/// short, a coordinate that is not a finite number, an index out of range, no faces. `report` may be null.
///
/// The file is read in a stream. Limits: 8 GiB, 2^20 characters a line, 2^26 `v` lines, 2^27 `vt` lines and
/// triangles.
[[nodiscard]] WEFT_API Result<Mesh> load_obj(const std::filesystem::path& file,
                                             const ObjOptions& options = {}, ObjReport* report = nullptr);

/// Writes positions, texture coordinates (the pattern, where there are none) and triangles, with nine digits,
/// so that floats read back the same. Rows and columns are not kept. Errors: a mesh of which no cloth could
/// be made, naming the element; a file that cannot be written.
[[nodiscard]] WEFT_API Result<void> save_obj(const std::filesystem::path& file, const Mesh& mesh);

}  // namespace weft
