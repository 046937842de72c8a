#pragma once
// The plain values of Weft's interface. SI units, float32, right-handed coordinates, +Y up.

#include <cstdint>

namespace weft {

/// Two floats: texture coordinates, or a point of a flat pattern [m].
struct Vec2 {
    float x = 0, y = 0;
};

/// Three floats: a point [m], a direction, or a velocity [m/s].
struct Vec3 {
    float x = 0, y = 0, z = 0;
};

/// One element of a per-particle buffer: sixteen bytes, aligned, so that it is loaded as one 128-bit word by
/// the solver and uploaded as it is by a renderer. What `w` holds is said by each buffer.
struct alignas(16) Vec4 {
    float x = 0, y = 0, z = 0, w = 0;
};

/// Axis-aligned box [m]. Empty while lower > upper.
struct Bounds {
    Vec3 lower{}, upper{};
};

}  // namespace weft
