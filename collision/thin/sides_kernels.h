#pragma once
// The sides of a box beyond which particles stay over a substep: the test that rejects most triangles.

#include <cstdint>
#include <span>

#include "engine/vector.h"
#include "weft/types.h"

namespace weft {

/// A box in a local frame that may turn over a substep.
struct TurningBox {
    Matrix3 to_own, to_own_at_start;
    Vector3 origin, origin_at_start;
    Vector3 lower, upper;  ///< [m]
};

/// Finds a bit for each of the six sides beyond which a particle is at both start and end, with a margin for
/// rounding. A triangle whose particles have a bit in common is outside the box at both ends and between
/// them. A particle that is not a number has no bits. Precondition: as many of all three.
void find_sides(const TurningBox& box, std::span<const Vec4> starts, std::span<const Vec4> positions,
                std::span<std::uint32_t> sides);

}  // namespace weft
