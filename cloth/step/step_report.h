#pragma once
// A step's report, of each cloth and of all of them.

#include "cloth/simulation/simulation.h"

namespace weft {

/// Adds a cloth's report to that of the step.
void add_to_report(StepReport& report, const ClothReport& cloth);

}  // namespace weft
