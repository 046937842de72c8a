#pragma once
// Gusts at one point, as the noise is defined: the reference of the kernel.

#include "cloth/air/gusts.h"

namespace weft::test {

/// A vector with components uniform in [-1, 1), for a lattice point.
inline Vector3 lattice_value(int x, int y, int z, std::uint32_t seed) {
    const auto wrapped = [](int c) { return static_cast<std::uint32_t>(c & (WindField::period - 1)); };
    std::uint32_t bits = wrapped(x) | wrapped(y) << 8 | wrapped(z) << 16;
    bits = (bits ^ seed * 0x9E3779B1u) * 0x2C1B3C6Du;
    bits = (bits ^ (bits >> 12)) * 0x297A2D39u;
    bits ^= bits >> 15;
    const auto component = [&](int shift) {
        return static_cast<float>((bits >> shift) & 0x3FFu) * (2.0f / 1024.0f) - (1023.0f / 1024.0f);
    };
    return {component(0), component(10), component(20)};
}

inline Vector3 value_noise(const Vector3& p, std::uint32_t seed) {
    const Vector3 cell = p.array().floor();
    const int x = static_cast<int>(cell.x()), y = static_cast<int>(cell.y()), z = static_cast<int>(cell.z());
    const auto fade = [](float t) { return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f); };
    const float u = fade(p.x() - cell.x()), v = fade(p.y() - cell.y()), w = fade(p.z() - cell.z());
    Vector3 sum = Vector3::Zero();
    for (int corner = 0; corner < 8; ++corner) {
        const int dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
        const float weight = (dx == 1 ? u : 1 - u) * (dy == 1 ? v : 1 - v) * (dz == 1 ? w : 1 - w);
        sum += weight * lattice_value(x + dx, y + dy, z + dz, seed);
    }
    return sum;
}

inline Vector3 gusty_velocity(const WindField& field, const Vector3& point) {
    Vector3 sum = Vector3::Zero();
    float weight = 2.2333f;  // makes the root mean square 1
    for (const WindField::Octave& octave : field.octaves) {
        sum += weight * value_noise(point * octave.scale + octave.offset, octave.seed);
        weight *= 0.5f;
    }
    return field.mean + field.amplitude * sum;
}

}  // namespace weft::test
