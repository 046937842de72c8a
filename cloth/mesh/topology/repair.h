#pragma once
// Repairs of a mesh in cooking: welding, leaving out and turning triangles. See CookReport.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cloth/mesh/topology/topology.h"

namespace weft {

/// One side of a triangle.
struct Side {
    std::uint32_t low, high;  ///< particles, low < high
    std::uint32_t triangle;
    std::uint32_t opposite;
};

/// The sides of all triangles, ascending by edges and in these by triangles.
[[nodiscard]] std::vector<Side> sides_by_edge(std::span<const Triangle> triangles);
/// The sides of the edge of sides[begin], which follow one another.
[[nodiscard]] std::span<const Side> sides_of_edge(std::span<const Side> sides, std::size_t begin);
/// The number of triangles of each particle.
[[nodiscard]] std::vector<std::uint32_t> triangle_counts(const Topology& topology);

/// One particle number per vertex, ascending by first vertex. Vertices at one position are welded along open
/// edges: two edges of one triangle each that lie at one place, with triangles that do not lie on each other
/// unless the mesh has a pattern. So a surface that was split along seams closes, and layers that touch stay
/// apart. A vertex without triangles joins the first vertex at its position.
///
/// Precondition: the mesh's indices are in range.
[[nodiscard]] std::vector<std::uint32_t> weld_open_edges(const Mesh& mesh);

/// Leaves out each triangle, in the mesh's order, for which its edges or particles have no room. Returns the
/// sides of those that stay, by edges and in these by triangles: two at most of an edge.
std::vector<Side> leave_out_crowding(Topology& topology);

/// The number of edges whose two triangles are wound against each other.
[[nodiscard]] std::uint32_t count_misoriented(const Topology& topology);

/// Turns the smaller part of each connected piece whose parts are wound against each other. A piece that no
/// turning makes alike stays, and its misoriented edges are counted. Precondition: edges are built.
void turn_alike(const Mesh& mesh, Topology& topology);

}  // namespace weft
