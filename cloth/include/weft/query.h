#pragma once
// Places on cloths, as a World's queries find them.

#include <cstdint>

#include "weft/cloth_id.h"
#include "weft/types.h"

namespace weft {

/// A place on a cloth's surface.
struct ClothPoint {
    ClothId cloth{};             ///< the cloth that it is on
    std::uint32_t triangle = 0;  ///< its number in ClothView::triangles
    Vec3 weights{};              ///< of the triangle's corners, each from 0, with the sum 1
    Vec3 position{};             ///< the corners' positions by these weights [m]
    /// Of the triangle: unit length, out of its front; 0 if it has no area. A ray that comes from behind runs
    /// along it.
    Vec3 normal{};
    float distance = 0;  ///< from the start of the ray, or from the point that was asked about [m]
};

}  // namespace weft
