#pragma once
// The solve of a substep.

#include <cstdint>
#include <span>

#include "cloth/simulation/simulation.h"
#include "cloth/simulation/substep.h"

namespace weft {

/// A group of cloths takes the substep, of a step of dt seconds, as one equation, in as many parts as it
/// needs.
void solve(Simulation& world, Worker& worker, std::span<Cloth* const> cloths, float dt,
           const Substep& substep);

}  // namespace weft
