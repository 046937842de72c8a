#pragma once
// A pose, or a motion without a change of shape.

#include "weft/collider.h"
#include "weft/types.h"

namespace weft {

/// Maps the point x to rotation x + translation. As a pose it maps a frame's own coordinates to the World's.
struct Transform {
    Vec3 translation{};   ///< [m]
    Rotation rotation{};  ///< about the origin
};

}  // namespace weft
