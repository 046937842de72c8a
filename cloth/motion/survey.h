#pragma once
// One pass over the state that finds its extent, its fastest particle, and whether it is still sound.

#include <cstdint>
#include <span>

#include "cloth/mesh/coordinates.h"
#include "cloth/state/state.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

struct Survey {
    Vec3 lower, upper;         ///< [m]; lower > upper for no particles
    float peak_speed_squared;  ///< [m^2/s^2]
    bool sound;                ///< all finite, and no position beyond runaway_distance
};

/// Precondition: partials.size() >= block_count(particles).
[[nodiscard]] Survey survey(Parallel& parallel, const ClothState& state, std::span<Survey> partials);

}  // namespace weft
