#pragma once
// The end of a substep: integrates the solved velocities to new positions.

#include <span>

#include "cloth/equation/step_equation.h"
#include "cloth/state/state.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

/// Input and output of advance(). All spans are of AlignedBuffers.
struct Advance {
    std::span<const Vec4> solved;  ///< velocities at the end of the substep [m/s], w 0
    float max_speed;               ///< solved velocities are clamped to it [m/s]
    std::span<Vec4> velocities;    ///< those of the equation, which are overwritten
    std::span<Vec4> positions;     ///< at the end of the substep [m]
    StepRecord* record;            ///< record of the substep for BDF2; null with other time schemes
};

/// Stores the solved velocities v and the positions x = x_base + gamma v (Kang, eq. 1, where x_base is x and
/// gamma is h).
void advance(Parallel& parallel, const StepEquation& equation, const Advance& change);

/// Clamps velocities to the length `max_speed` [m/s]. `velocities` are in an AlignedBuffer.
void limit_speeds(Parallel& parallel, float max_speed, std::span<Vec4> velocities);

}  // namespace weft
