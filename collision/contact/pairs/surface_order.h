#pragma once
// Vertices in an order in which those that follow one another lie together along a surface, however it lies
// in space.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "weft/types.h"

namespace weft {

/// Puts the vertices of a surface in order of patches: each sixteen are one piece of it, as round as that
/// goes, and so is each block of patches. `edges` are between these vertices. Positions count for the lengths
/// of edges alone; those of vertices have to be finite.
void order_along_surface(std::span<std::uint32_t> vertices,
                         std::span<const std::array<std::uint32_t, 2>> edges,
                         std::span<const Vec4> rest_positions);

}  // namespace weft
