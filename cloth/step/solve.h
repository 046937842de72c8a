#pragma once
// The solve of a substep.

#include <cstdint>
#include <span>

#include "cloth/simulation/simulation.h"
#include "cloth/simulation/substep.h"

namespace weft {

/// Solves a substep of a group of cloths, in a step of dt seconds, in as many parts as colliders and contact
/// need.
void solve(Simulation& world, Worker& worker, std::span<Cloth* const> cloths, float dt,
           const Substep& substep);

}  // namespace weft
