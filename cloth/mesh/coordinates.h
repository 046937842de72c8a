#pragma once
// How far from the origin cloth may be.

namespace weft {

/// Beyond it, single precision and every scene that cloth belongs in are left behind [m], on any axis.
inline constexpr float runaway_distance = 1e5f;

}  // namespace weft
