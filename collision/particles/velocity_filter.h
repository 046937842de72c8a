#pragma once
// The simplest response to colliders: what is inside may not go farther in (D. I. W. Levin, CSC2549
// Physics-Based Animation, assignment 4, 2020).

#include <cstdint>
#include <span>

#include "collision/colliders/collider_contacts.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

/// Takes n n^T v from every free particle inside a shape, n being the outward normal of the surface that is
/// nearest at the substep's end and v the velocity relative to that surface, where n^T v < 0. The source has
/// one sphere at rest; this is the same for any shape that moves. Positions stay: what is inside stays
/// inside, and goes in by a step's way before it is stopped at all. There is no friction and no
/// bounce. mask: of ClothSide. h: length of the
/// substep [s]. Returns the number of particles inside. Precondition: block_partials.size() >=
/// block_count(positions.size()); both arrays go on to the end of a group of 16.
std::uint32_t filter_velocities(Parallel& parallel, std::span<const ColliderMotion> colliders,
                                std::uint32_t mask, float h, std::span<const Vec4> positions,
                                std::span<Vec4> velocities, std::span<std::uint32_t> block_partials);

}  // namespace weft
