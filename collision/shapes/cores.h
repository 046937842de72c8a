#pragma once
// What of a collider goes between the particles of cloth: its core, which is points and edges with a ball
// about each. Features of cloth are kept from passing it as they are from passing one another.

#include <cstdint>
#include <span>

#include "collision/collider_contacts.h"
#include "collision/contact/common_motion.h"
#include "collision/contact/contact_mesh.h"
#include "weft/collider.h"
#include "weft/types.h"

namespace weft {

/// Of what is round and not thin, the core of cloth whose edges are so long at rest [m] is nothing: particles
/// meet it. Of a sphere it is its centre, of a capsule its axis, of a box its edges. Null: it has none.
[[nodiscard]] const ContactMesh* core_of(const Collider& collider, float edge);

/// What has no more particles than any core.
[[nodiscard]] const ContactMesh& largest_core();

/// Where the particles of its core are; w: the radius of the ball about them [m]. Precondition: it has one.
void place_core(const Collider& collider, std::span<Vec4> points);

/// As a whole, from start to end.
[[nodiscard]] CommonMotion motion_of_core(const ColliderMotion& motion);

/// Whether it moves farther in h [s] than it may move anything: then it has jumped, and sweeps nothing.
[[nodiscard]] bool has_jumped(const ColliderMotion& motion, float h);

}  // namespace weft
