#pragma once
// Where a collider's surface is nearest to one point.

#include "engine/vector.h"
#include "weft/collider.h"

namespace weft {

struct SurfacePoint {
    Vector3 point;   ///< [m]
    Vector3 normal;  ///< of unit length, outward
    float distance;  ///< of what was asked for from it [m]; below 0 inside
};

[[nodiscard]] SurfacePoint nearest_surface(const Collider& collider, const Vector3& to);

}  // namespace weft
