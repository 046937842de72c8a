#pragma once
// Which cloths a step takes.

#include "cloth/simulation/simulation.h"

namespace weft {

/// Finds those that are enabled and awake, for a step of dt seconds.
void choose_present(Simulation& world, float dt);
/// After a step.
void count_still_time(Cloth& cloth, float dt);

}  // namespace weft
