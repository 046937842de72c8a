#pragma once
// Orders vertices so that successive ones are close along a surface, however it lies in space.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "weft/types.h"

namespace weft {

/// Puts the vertices of a surface in order of patches: each sixteen are one compact piece of it, and so is
/// each block of patches. `edges` are between these vertices. Positions are used for the lengths of edges
/// only; those of vertices have to be finite.
void order_along_surface(std::span<std::uint32_t> vertices,
                         std::span<const std::array<std::uint32_t, 2>> edges,
                         std::span<const Vec4> rest_positions);

}  // namespace weft
