#pragma once
// One pass over the state that finds its extent, its fastest particle, and whether it is still sound.

#include <cstdint>
#include <span>

#include "cloth/state.h"
#include "engine/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

/// Beyond these, single precision and every scene that cloth belongs in are left behind: the state has run
/// away.
inline constexpr float runaway_distance = 1e5f;  ///< [m], from the origin, on any axis
inline constexpr float runaway_speed = 1e5f;     ///< [m/s]

struct Survey {
    Vec3 lower, upper;         ///< [m]; lower > upper for no particles
    float peak_speed_squared;  ///< [m^2/s^2]
    bool sound;                ///< all finite, and no position beyond runaway_distance
};

/// Precondition: partials.size() >= block_count(particles).
[[nodiscard]] Survey survey(Parallel& parallel, const ClothState& state, std::span<Survey> partials);

}  // namespace weft
