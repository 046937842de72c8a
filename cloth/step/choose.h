#pragma once
// The budget's choice of each cloth's level of detail, and cloths that take long steps.

#include "cloth/simulation/simulation.h"
#include "cloth/simulation/substep.h"

namespace weft {

/// Chooses rungs and rates before a step; learn_costs() updates their costs after it.
void choose_details(Simulation& world);
void learn_costs(Simulation& world);

/// After a long step: begin_stride() returns the cloth to its start, and glide(), once in each step of the
/// World, interpolates it evenly to its end.
void begin_stride(Simulation& world, Worker& worker, Cloth& cloth);
void glide(Simulation& world, Worker& worker, Cloth& cloth);

}  // namespace weft
