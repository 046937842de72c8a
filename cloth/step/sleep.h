#pragma once
// The choice of the cloths that a step takes.

#include "cloth/simulation/simulation.h"

namespace weft {

/// Lists the cloths that are enabled and awake, for a step of dt seconds.
void choose_present(Simulation& world, float dt);
/// Updates a cloth's time of stillness, after a step of dt seconds.
void count_still_time(Cloth& cloth, float dt);

}  // namespace weft
