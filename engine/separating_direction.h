#pragma once
// A direction in which to separate two particles at the same point.

#include <cmath>
#include <cstdint>

#include "engine/vector.h"

namespace weft {

/// A unit vector that depends on the two indices alone and changes sign when they are swapped: both particles
/// of a pair then move apart, the same way at every run. The vectors are spread evenly over the sphere, so
/// that a cloth collapsed to one point opens in all directions and not along a line.
inline Vector3 separating_direction(std::uint32_t i, std::uint32_t j) {
    const std::uint32_t low = i < j ? i : j;
    const std::uint32_t high = i < j ? j : i;
    std::uint32_t bits =
        low * 0x9E3779B1u ^ high * 0x85EBCA77u;  // odd multipliers, then a finaliser: mixed bits
    bits = (bits ^ (bits >> 15)) * 0x2C1B3C6Du;
    bits = (bits ^ (bits >> 12)) * 0x297A2D39u;
    bits ^= bits >> 15;
    // Archimedes: z uniform in (-1, 1) and an independent angle give a uniform point of the sphere.
    const float z = (static_cast<float>(bits & 0xFFFFu) + 0.5f) * (2.0f / 65536.0f) - 1.0f;
    const float angle = static_cast<float>(bits >> 16) * (6.28318531f / 65536.0f);
    const float radius = std::sqrt(1.0f - z * z);
    const Vector3 direction{radius * std::cos(angle), radius * std::sin(angle), z};
    return i < j ? direction : Vector3(-direction);
}

}  // namespace weft
