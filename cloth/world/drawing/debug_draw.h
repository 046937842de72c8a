#pragma once

#include "weft/debug_draw.h"

namespace weft {

struct Simulation;

/// See World::debug_draw.
void debug_draw(const Simulation& simulation, const DebugCanvas& canvas, DebugParts parts);

}  // namespace weft
