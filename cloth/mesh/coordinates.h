#pragma once
// How far from the origin cloth may be.

namespace weft {

/// The farthest that a coordinate may be from 0 [m]: beyond it single precision cannot resolve cloth.
inline constexpr float runaway_distance = 1e5f;

}  // namespace weft
