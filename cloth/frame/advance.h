#pragma once
// The end of a substep: from the velocities that a solver found to new velocities and positions.

#include <span>

#include "cloth/frame/history.h"
#include "cloth/system/step_equation.h"
#include "engine/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

/// What a substep changes; all in AlignedBuffers.
struct Advance {
    std::span<const Vec4> solved;  ///< a solver's velocities [m/s], w 0
    float max_speed;               ///< what is faster is slowed down to it [m/s]
    std::span<Vec4> velocities;    ///< those of the equation, which are overwritten
    std::span<Vec4> positions;     ///< the new ones
    History* history;              ///< null without BDF2
};

/// x = x_base + gamma v (Kang, eq. 1, where x_base is x and gamma is h).
void advance(Parallel& parallel, const StepEquation& equation, const Advance& change);

}  // namespace weft
