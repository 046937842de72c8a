#pragma once
// Cloths that are added where others lie.

#include "cloth/simulation/simulation.h"

namespace weft {

/// Before a cloth is added: logs how many of its particles are exactly where those of a cloth are that it may
/// meet by contact. Contact parts the two: the later cloth comes to lie before the front of the earlier one.
void log_coincident(const Simulation& world, const Cloth& added);

}  // namespace weft
