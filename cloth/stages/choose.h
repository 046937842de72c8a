#pragma once
// How each cloth is taken by a step, where the World has a budget.

#include "cloth/simulation/simulation.h"
#include "cloth/simulation/substep.h"

namespace weft {

/// Chooses rungs and rates before a step; after it takes over what they cost.
void choose_details(Simulation& world);
void learn_costs(Simulation& world);

/// After a long step: the cloth goes from where it began to where it ended evenly, once in each step.
void begin_stride(Simulation& world, Worker& worker, Cloth& cloth);
void glide(Simulation& world, Worker& worker, Cloth& cloth);

}  // namespace weft
