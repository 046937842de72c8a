#pragma once
// What each cloth does for itself in a step.

#include "cloth/simulation/simulation.h"
#include "cloth/simulation/substep.h"

namespace weft {

/// Before a substep is solved, of a step of dt seconds: goes with its frame, sends pins on their way, and
/// feels the air.
void predict(Simulation& world, Worker& worker, Cloth& cloth, float dt, const Substep& substep);
/// Once all substeps are solved: sees that the state is sound, and makes what is drawn. One on a long step
/// goes on to where that ended.
void arrive(Simulation& world, Worker& worker, Cloth& cloth);

}  // namespace weft
