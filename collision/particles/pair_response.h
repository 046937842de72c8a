#pragma once
// The response of pairs that are too close, many pairs at a time; compiled once for each kind of machine.

#include <array>
#include <cstdint>

#include "weft/types.h"

namespace weft {

struct ResponseSettings {
    float distance, friction, h;
};

/// A batch of pairs (i, j), and the results: i's displacement [m] and change of velocity [m/s].
struct PairBatch {
    static constexpr std::uint32_t capacity = 64;

    std::uint32_t count = 0;
    alignas(64) std::array<std::uint32_t, capacity> i, j;
    alignas(64) std::array<float, capacity> sharers;  ///< divisor of the response
    std::array<Vec4, capacity> displacement, velocity_change;
};

/// Computes the response of Kang, section IV, equations 8 to 10, about the pair's centre of mass and to the
/// stated distance (equation 8 read literally doubles it). Coulomb friction is limited by the normal impulse
/// of equation 10 alone: if the push counted as an impulse too, layers that stay overlapped would stick
/// together, and the more so the shorter the step. Friction changes the step's motion as it changes the
/// velocity, so that layers at rest do not creep.
///
/// Exchanging the particles exchanges signs and nothing else, to the last bit. positions.w is the inverse
/// mass. Precondition: one of the two is free.
void respond_to_pairs(const ResponseSettings& settings, const Vec4* positions, const Vec4* velocities,
                      PairBatch& batch);

}  // namespace weft
