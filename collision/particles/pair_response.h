#pragma once
// What pairs that are too close ask of each other, many pairs at a time; compiled once for each kind of
// machine.

#include <array>
#include <cstdint>

#include "weft/types.h"

namespace weft {

struct ResponseSettings {
    float distance, friction, h;
};

/// Pairs (i, j) on their way through the arithmetic, and what comes out: i's displacement [m] and change of
/// velocity [m/s].
struct PairBatch {
    static constexpr std::uint32_t capacity = 64;

    std::uint32_t count = 0;
    alignas(64) std::array<std::uint32_t, capacity> i, j;
    alignas(64) std::array<float, capacity> sharers;  ///< what is asked for is divided by it
    std::array<Vec4, capacity> displacement, velocity_change;
};

/// Kang, section IV, equations 8 to 10, about the pair's centre of mass and to the stated distance (equation
/// 8 read literally doubles it). Coulomb friction is limited by the normal impulse of equation 10 alone: if
/// it counted the push as an impulse too, layers that stay overlapped would stick together, and the more so
/// the shorter the step. What friction changes in the velocity it changes in the step's motion too, so that
/// layers at rest do not creep.
///
/// Exchanging the particles exchanges signs and nothing else, to the last bit. positions.w is the inverse
/// mass. Precondition: one of the two is free.
void respond_to_pairs(const ResponseSettings& settings, const Vec4* positions, const Vec4* velocities,
                      PairBatch& batch);

}  // namespace weft
