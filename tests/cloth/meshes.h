#pragma once
// Meshes of known shape, for tests of what is made from a mesh.

#include <cstdint>
#include <string>
#include <vector>

#include "tests/must.h"
#include "weft/mesh.h"

namespace weft::test {

struct NamedMesh {
    std::string name;
    Mesh mesh;
    int components = 1;
    int euler_characteristic = 1;  ///< vertices - edges + faces: 1 of a disc, 2 of a sphere, 0 of a ring
    bool has_border = true;
};

/// The sheet without its rows and columns: a general mesh.
[[nodiscard]] Mesh loose_sheet(std::uint32_t rows, std::uint32_t columns);

/// Level, its middle above the origin, turned about that by an angle [rad], so that its mesh does not lie
/// over another's.
[[nodiscard]] Mesh turned_sheet(float height, float turn = 0, std::uint32_t side = 13, float size = 0.4f);

/// A grid whose cells are all cut along the same diagonal: all its inner particles have the same mass.
[[nodiscard]] Mesh evenly_cut(const SheetSettings& settings);

/// A closed sphere of radius 1 about the origin, triangles facing outwards: the icosahedron, each face cut in
/// four `subdivisions` times.
[[nodiscard]] Mesh sphere(int subdivisions);

/// An open tube of radius 1 and height 2 about +Y. Its texture coordinates unroll it, so that the vertices of
/// the seam occur twice: rows * (columns + 1) vertices at rows * columns positions.
[[nodiscard]] Mesh tube(std::uint32_t rows, std::uint32_t columns);

/// One-sided: somewhere two neighbours are wound against each other. 2 * length particles.
[[nodiscard]] Mesh moebius_strip(std::uint32_t length);

/// `triangles` triangles around vertex 0, in the plane y = 0, spread over two radians.
[[nodiscard]] Mesh fan(std::uint32_t triangles);

/// Both meshes, the second moved by `offset`.
[[nodiscard]] Mesh joined(const Mesh& first, const Mesh& second, const Vec3& offset);

/// Whole meshes without faults that differ in all that topology tells apart.
[[nodiscard]] std::vector<NamedMesh> sound_meshes();

}  // namespace weft::test
