#pragma once
// Coulomb's law, as contacts of all kinds apply it.

#include "engine/vector.h"

namespace weft {

/// What friction takes from a velocity that slides along a contact: all of it, or as much as `limit`, the
/// friction coefficient times the normal velocity that the contact took away [m/s].
inline Vector3 stopped_by_friction(const Vector3& sliding, float limit) {
    const float speed = sliding.norm();
    return speed > limit ? Vector3(sliding * (limit / speed)) : sliding;
}

}  // namespace weft
