#pragma once
// The end of a substep: from the velocities that were solved for to new positions.

#include <span>

#include "cloth/equation/step_equation.h"
#include "cloth/state/state.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

/// What a substep changes; all in AlignedBuffers.
struct Advance {
    std::span<const Vec4> solved;  ///< velocities at the end of the substep [m/s], w 0
    float max_speed;               ///< what is faster is slowed down to it [m/s]
    std::span<Vec4> velocities;    ///< those of the equation, which are overwritten
    std::span<Vec4> positions;     ///< the new ones
    StepRecord* record;            ///< what BDF2 is to know of the substep; null without it
};

/// Takes the solved velocities over, then x = x_base + gamma v (Kang, eq. 1, where x_base is x and gamma is
/// h).
void advance(Parallel& parallel, const StepEquation& equation, const Advance& change);

/// What is faster is slowed down to `max_speed` [m/s]. `velocities` are in an AlignedBuffer.
void limit_speeds(Parallel& parallel, float max_speed, std::span<Vec4> velocities);

}  // namespace weft
