#pragma once
// Check of the present positions of a mesh's vertices, which a host gives.

#include <span>

#include "weft/cutting.h"

namespace weft {

/// Error: another number of positions than of vertices, a position that is not finite, or a triangle with a
/// vertex out of range.
[[nodiscard]] Result<void> check_positions(const Mesh& mesh, std::span<const Vec3> positions);

}  // namespace weft
