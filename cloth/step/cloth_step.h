#pragma once
// The stages of a step that each cloth takes for itself.

#include "cloth/simulation/simulation.h"
#include "cloth/simulation/substep.h"

namespace weft {

/// Before the solve of a substep, in a step of dt seconds: transports the cloth with its frame, sets its
/// pins' velocities, and computes the air's forces.
void predict(Simulation& world, Worker& worker, Cloth& cloth, float dt, const Substep& substep);
/// After all substeps: checks that the state is sound, and computes normals. A cloth in a long step is
/// interpolated towards that step's end instead.
void arrive(Simulation& world, Worker& worker, Cloth& cloth);

}  // namespace weft
