#pragma once
// The air's part of a step.

#include "cloth/simulation/simulation.h"
#include "cloth/simulation/substep.h"

namespace weft {

/// Samples the air's velocities at the cloth's particles.
void feel_wind(Simulation& world, Worker& worker, Cloth& cloth);
/// Computes the air's forces on the cloth. `has_moved`: it has moved since its normals were computed.
void air_forces(Simulation& world, Worker& worker, Cloth& cloth, bool has_moved);

}  // namespace weft
