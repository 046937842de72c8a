#pragma once
// Cloth that is found so deep inside a collider that the nearest ways out would tear it apart.

#include <array>
#include <cstdint>
#include <span>

#include "collision/colliders/collider_contacts.h"

namespace weft {

/// Call this after collide_particles() has left particles inside of colliders. Where the ways to the nearest
/// surface draw neighbouring particles apart, as on both sides of a box's middle, all of the cloth that is
/// inside leaves that collider in one direction of the World's axes, by which it is out first.
void lead_out(std::span<const std::array<std::uint32_t, 3>> triangles, float mean_edge,
              std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h,
              const CollidingParticles& particles);

}  // namespace weft
