#pragma once
// The order in which a mesh's particles lie in memory.

#include <cstdint>
#include <span>
#include <vector>

#include "cloth/mesh/topology/topology.h"

namespace weft {

/// order[new number] = present number. Neighbours get numbers that are near (reverse Cuthill-McKee; component
/// by component, ascending), and of each 256 particles the best connected come first: groups of particles
/// that kernels work on together then have nearly as many springs each, and waste few lanes.
[[nodiscard]] std::vector<std::uint32_t> memory_order(const Topology& topology);

/// Renumbers the particles, and sorts again whatever was in ascending order of particles. Precondition:
/// `order` is a permutation.
void renumber(Topology& topology, std::span<const std::uint32_t> order);

}  // namespace weft
