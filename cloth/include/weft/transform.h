#pragma once
// Where something is, or how it is moved, without a change of shape.

#include "weft/collider.h"
#include "weft/types.h"

namespace weft {

/// The point x goes to rotation x + translation. As a pose it takes a frame's own coordinates to the World's.
struct Transform {
    Vec3 translation{};   ///< [m]
    Rotation rotation{};  ///< about the origin
};

}  // namespace weft
