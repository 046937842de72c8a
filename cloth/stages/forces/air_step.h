#pragma once
// The air's part of a step.

#include "cloth/simulation/simulation.h"
#include "cloth/simulation/substep.h"

namespace weft {

/// Samples the air's velocities at the cloth's particles.
void feel_wind(Simulation& world, Worker& worker, Cloth& cloth);
/// The air's force on the cloth in a substep that begins as it is now.
[[nodiscard]] AirForce air_force(const Simulation& world, Cloth& cloth);
/// Computes that force where the substep begins. `keeps_normals`: see Surface.
void find_air_forces(Simulation& world, Worker& worker, Cloth& cloth, bool keeps_normals);

}  // namespace weft
