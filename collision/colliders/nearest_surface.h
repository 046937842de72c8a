#pragma once
// Where a collider's surface is nearest to one point.

#include "engine/vector.h"
#include "weft/collider.h"

namespace weft {

class HeldShape;

struct SurfacePoint {
    Vector3 point;   ///< [m]
    Vector3 normal;  ///< of unit length, outward
    float distance;  ///< of what was asked for from it [m]; below 0 inside
};

/// `held`: of a PlacedShape, which is looked for within 0.1 m of its outside; farther away it is at an
/// infinite distance.
[[nodiscard]] SurfacePoint nearest_surface(const Collider& collider, const Vector3& to,
                                           const HeldShape* held = nullptr);

}  // namespace weft
