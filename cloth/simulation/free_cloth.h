#pragma once
// Cloths and bodies that nothing else holds keep their common momentum.

#include <span>

#include "cloth/equation/moving_body.h"
#include "cloth/equation/step_equation.h"
#include "cloth/instance/cloth.h"

namespace weft {

/// Restores momentum that the solve has lost: few iterations leave a residual, and an implicit step loses
/// angular momentum. Cloths of one equation that gave impulses to the same bodies, or whose features touch,
/// get one rigid velocity change together with these bodies. It supplies the momentum that the velocities in
/// scratch_velocities lack, given the bodies' impulses (CollectedShare::in_part) and external ones. A change
/// of the cloth alone would make it pull ever more at what it is attached to. Does nothing where anything
/// else holds one of them. A body's change goes to the share of the first cloth that gave it an impulse.
void keep_momentum_with_bodies(std::span<Cloth* const> cloths, std::span<const StepEquation> equations,
                               std::span<MovingBody> bodies);

}  // namespace weft
