#pragma once
// Where a mesh's vertices are now, as a host gives it.

#include <span>

#include "weft/cutting.h"

namespace weft {

/// Error: another number than of vertices, one that is not finite, or a triangle of a vertex that there is
/// not.
[[nodiscard]] Result<void> check_positions(const Mesh& mesh, std::span<const Vec3> positions);

}  // namespace weft
