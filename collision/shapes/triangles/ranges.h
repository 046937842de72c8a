#pragma once

namespace weft {

/// Greatest coordinate and greatest size of colliders [m].
inline constexpr float farthest_collider = 1e5f;

}  // namespace weft
