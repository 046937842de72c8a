#pragma once
// The simplest response to colliders: particles inside may not move farther in (D. I. W. Levin, CSC2549
// Physics-Based Animation, assignment 4, 2020).

#include <cstdint>
#include <span>

#include "collision/colliders/collider_contacts.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

/// Subtracts n n^T v from the velocity of every free particle inside a shape where n^T v < 0. n is the
/// outward normal of the surface that is nearest at the substep's end, v the velocity relative to that
/// surface. The source has one sphere at rest; this is the same for any moving shape. Positions do not
/// change: a particle inside stays inside, and enters by a step's motion before it is stopped. There is no
/// friction and no bounce. Of `cloth` only the masks count. h: length of the substep [s]. Returns the number
/// of particles inside. Precondition: block_partials.size() >= block_count(positions.size()); both arrays are
/// padded to a multiple of 16.
std::uint32_t filter_velocities(Parallel& parallel, std::span<const ColliderMotion> colliders,
                                const ClothSide& cloth, float h, std::span<const Vec4> positions,
                                std::span<Vec4> velocities, std::span<std::uint32_t> block_partials);

}  // namespace weft
