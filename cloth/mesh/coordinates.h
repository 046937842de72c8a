#pragma once
// The greatest distance of cloth from the origin.

namespace weft {

/// The farthest that a coordinate may be from 0 [m]: beyond it single precision cannot resolve cloth.
inline constexpr float runaway_distance = 1e5f;

}  // namespace weft
