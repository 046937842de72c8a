#pragma once
// On which sides of a box particles lie all the way: what most triangles are left out by.

#include <cstdint>
#include <span>

#include "engine/vector.h"
#include "weft/types.h"

namespace weft {

/// A box in a space that may turn over a substep.
struct TurningBox {
    Matrix3 to_own, to_own_at_start;
    Vector3 origin, origin_at_start;
    Vector3 lower, upper;  ///< [m]
};

/// A bit for each of the six sides beyond which a particle is both at the start and at the end; a little
/// beyond, so that rounding adds none. Nothing that spans particles which have a bit in common is in the box
/// at either, or between the two. What is no number has none. Precondition: as many of all three.
void find_sides(const TurningBox& box, std::span<const Vec4> starts, std::span<const Vec4> positions,
                std::span<std::uint32_t> sides);

}  // namespace weft
