#pragma once
// The air's part of a step.

#include "cloth/simulation/simulation.h"
#include "cloth/simulation/substep.h"

namespace weft {

/// Finds the air's velocities where the cloth is.
void feel_wind(Simulation& world, Worker& worker, Cloth& cloth);
/// Then what it does to it; `has_moved`: since normals were made last.
void air_forces(Simulation& world, Worker& worker, Cloth& cloth, bool has_moved);

}  // namespace weft
