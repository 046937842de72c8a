#pragma once
// Flips of edges that remove slivers.

#include "cloth/mesh/topology/topology.h"

namespace weft {

/// Flips the longest edges of slivers: of triangles whose springs would be stiffer than
/// greatest_side_stiffness, and of those without area that were left out. An edge is flipped if that leaves
/// the stiffer of its two triangles at most half as stiff: a T-junction that a sliver closes becomes two
/// sound triangles (Lawson 1977, for the flips). The surface moves by less than the sliver's height.
/// Triangles that still have no area stay left out.
///
/// An edge stays if it is a border's, if its two triangles are wound against each other, or if they have
/// different vertices at its ends in a mesh with a pattern or texture coordinates: a seam runs along it.
///
/// Precondition: triangles are wound alike as far as they can be, edges are built, and the mesh is no grid.
void flip_slivers(const Mesh& mesh, Topology& topology);

}  // namespace weft
