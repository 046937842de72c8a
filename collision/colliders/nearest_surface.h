#pragma once
// The point of a collider's surface that is nearest to a given point.

#include "engine/vector.h"
#include "weft/collider.h"

namespace weft {

class HeldShape;

struct SurfacePoint {
    Vector3 point;   ///< [m]
    Vector3 normal;  ///< of unit length, outward
    float distance;  ///< signed distance of the given point [m]; negative inside
};

/// `held`: the shape of a PlacedShape; farther outside of it than `sight` [m] the distance is infinite.
[[nodiscard]] SurfacePoint nearest_surface(const Collider& collider, const Vector3& to,
                                           const HeldShape* held = nullptr, float sight = 0.1f);

}  // namespace weft
