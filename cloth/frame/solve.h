#pragma once
// The solve of a substep.

#include <cstdint>
#include <span>

#include "cloth/frame/simulation.h"
#include "cloth/frame/substep.h"

namespace weft {

/// A group of cloths takes the substep, of a step of dt seconds, as one equation, in as many parts as it
/// needs.
void solve(Simulation& world, Worker& worker, std::span<Cloth* const> cloths, float dt,
           const Substep& substep);

/// How colliders see the cloth in a part of h seconds.
[[nodiscard]] ClothSide side_of(const Simulation& world, const Cloth& cloth, float h);
/// Pushes the cloth out of colliders at the end of a part of h seconds; `starts`: as weft::collide() has
/// them. Returns how many particles touch.
[[nodiscard]] std::uint32_t collide(Simulation& world, Worker& worker, Cloth& cloth, float h,
                                    std::span<const Vec4> starts);

}  // namespace weft
