#pragma once
// Particles at one point: a constraint between them has no direction.

#include <cstdint>

#include "engine/separating_direction.h"
#include "weft/types.h"

namespace weft {

/// Squared distances up to this count as 0 [m^2].
inline constexpr float coincident = 1e-24f;

/// Moves two particles at one point apart by a thousandth of their rest length, each by its inverse mass, so
/// that momentum is kept. The constraint then has a direction, the same one at every run.
inline void separate(std::uint32_t a, std::uint32_t b, float weight_a, float weight_b, float rest_length,
                     const Vec4* start, Vec4* moved) {
    const Vector3 apart = (xyz(start[b]) - xyz(start[a])) + (xyz(moved[b]) - xyz(moved[a]));
    const float weight = weight_a + weight_b;
    if (apart.squaredNorm() > coincident || weight == 0) return;
    const Vector3 step = 1e-3f * rest_length / weight * separating_direction(b, a);
    set_xyz(moved[a], xyz(moved[a]) - weight_a * step);
    set_xyz(moved[b], xyz(moved[b]) + weight_b * step);
}

}  // namespace weft
