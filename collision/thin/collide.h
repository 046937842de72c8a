#pragma once
// Cloth against colliders at the end of a substep: first its particles, then its whole triangles.

#include <cstdint>
#include <span>

#include "collision/colliders/collider_contacts.h"

namespace weft {

/// Moves every free particle (inverse mass > 0) that is nearer than the thickness to a collider's surface, or
/// inside it, out to the thickness. Its velocity relative to the surface loses the approach, gains the
/// bounce, and loses sliding by Coulomb's law. Friction moves the position too, so that cloth at rest on a
/// slope does not creep. Colliders act in order. h: length of the substep [s]. Returns how many particles,
/// and parts of whole triangles, met a collider. Preconditions: block_partials.size() >=
/// block_count(positions.size()); `cloth` has as many particles.
std::uint32_t collide(Parallel& parallel, std::span<const ColliderMotion> colliders, const ClothSide& cloth,
                      float h, const CollidingParticles& particles, std::span<std::uint32_t> block_partials);

}  // namespace weft
