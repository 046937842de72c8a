#pragma once
// A cloth that nothing holds but bodies keeps with them what momentum there is.

#include <span>

#include "cloth/frame/cloth.h"
#include "cloth/system/bodies/moving_body.h"
#include "cloth/system/step_equation.h"

namespace weft {

/// Few iterations leave a part of the equation unsolved, and an implicit step loses angular momentum: moves
/// and turns all of the cloth by what its solved velocities, in next_velocities, lack against what bodies got
/// (CollectedShare::in_part) and what acts from outside. Does nothing where something else holds the cloth,
/// or features of others meet it.
void keep_momentum_with_bodies(Cloth& cloth, const StepEquation& equation,
                               std::span<const MovingBody> bodies);

}  // namespace weft
