#pragma once
// A cloth that nothing holds but bodies keeps with them what momentum there is.

#include <span>

#include "cloth/equation/moving_body.h"
#include "cloth/equation/step_equation.h"
#include "cloth/instance/cloth.h"

namespace weft {

/// Few iterations leave a part of the equation unsolved, and an implicit step loses angular momentum: moves
/// and turns the cloth and the bodies that it gave something to, as one, by what the cloth's solved
/// velocities, in scratch_velocities, lack against what bodies got (CollectedShare::in_part) and what acts
/// from outside. The cloth alone would pull at what it is attached to, ever more. Does nothing where
/// something else holds one of them, or features of others meet the cloth.
void keep_momentum_with_bodies(Cloth& cloth, const StepEquation& equation, std::span<MovingBody> bodies);

}  // namespace weft
