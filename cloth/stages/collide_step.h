#pragma once
// Colliders after the equation: particles that are still inside are pushed out.

#include <cstdint>
#include <span>

#include "cloth/simulation/simulation.h"
#include "cloth/simulation/substep.h"

namespace weft {

/// The cloth's surface for colliders, in a part of h seconds.
[[nodiscard]] ClothSide side_of(const Simulation& world, const Cloth& cloth, float h);
/// Pushes the cloth out of colliders at the end of a part of h seconds; `starts`: as weft::collide() has
/// them. Returns how many particles touch.
[[nodiscard]] std::uint32_t collide(Simulation& world, Worker& worker, Cloth& cloth, float h,
                                    std::span<const Vec4> starts);

}  // namespace weft
