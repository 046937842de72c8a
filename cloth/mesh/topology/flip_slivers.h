#pragma once
// Slivers that can be flipped away.

#include "cloth/mesh/topology/topology.h"

namespace weft {

/// Flips the longest edge of each sliver whose springs would be stiffer than greatest_side_stiffness, and of
/// those without area that were left out, where that leaves the worse of the two triangles at the edge at
/// most half as stiff: a T-junction that a sliver closes becomes two sound triangles (Lawson 1977, for the
/// flips). The surface moves by less than the sliver's height. What has no area afterwards stays left out.
///
/// An edge stays if it is a border's, if its two triangles are wound against each other, or if they know its
/// ends by different vertices of a mesh with a pattern or texture coordinates: there a seam runs along it.
///
/// Precondition: triangles are wound alike as far as they can be, edges are built, and it is no grid.
void flip_slivers(const Mesh& mesh, Topology& topology);

}  // namespace weft
