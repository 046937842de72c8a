#pragma once
// Cloths and bodies that nothing else holds keep what momentum they have together.

#include <span>

#include "cloth/equation/moving_body.h"
#include "cloth/equation/step_equation.h"
#include "cloth/instance/cloth.h"

namespace weft {

/// Few iterations leave a part of the equation unsolved, and an implicit step loses angular momentum. Cloths
/// of one equation that gave something to the same bodies, or whose features touch, and these bodies are
/// moved and turned as one: by what the cloths' solved velocities, in scratch_velocities, lack against what
/// the bodies got (CollectedShare::in_part) and what acts from outside. A cloth alone would pull at what it
/// is attached to, ever more. Does nothing where something else holds one of them. A body's change goes to
/// the share of the first of them.
void keep_momentum_with_bodies(std::span<Cloth* const> cloths, std::span<const StepEquation> equations,
                               std::span<MovingBody> bodies);

}  // namespace weft
