#pragma once

namespace weft {

/// How far from the origin colliders may be, and how large [m].
inline constexpr float farthest = 1e5f;

}  // namespace weft
