#pragma once
// Fillings in a step, beside their part in the equation.

#include "cloth/simulation/simulation.h"

namespace weft {

/// Begins the cloth's filling for its next equation. Methods other than the passes have its force at the
/// present places, all through the step.
void begin_filling(Worker& worker, Cloth& cloth, const StepEquation& equation);
/// Gives a filling back the volume that colliders took when they pushed particles out of themselves.
void restore_volume(Worker& worker, Cloth& cloth);

}  // namespace weft
