#include "cloth/forces/gusts.h"

#include <cmath>

namespace weft {

namespace {

/// Lattice values repeat after this many cells, so that coordinates stay small floats however long the wind
/// has blown.
constexpr int period = 256;

/// A vector with components uniform in [-1, 1), for a lattice point.
Vector3 lattice_value(int x, int y, int z, std::uint32_t seed) {
    const auto wrapped = [](int c) { return static_cast<std::uint32_t>(c & (period - 1)); };
    std::uint32_t bits = wrapped(x) | wrapped(y) << 8 | wrapped(z) << 16;
    bits = (bits ^ seed * 0x9E3779B1u) * 0x2C1B3C6Du;
    bits = (bits ^ (bits >> 12)) * 0x297A2D39u;
    bits ^= bits >> 15;
    const auto component = [&](int shift) {
        return static_cast<float>((bits >> shift) & 0x3FFu) * (2.0f / 1024.0f) - (1023.0f / 1024.0f);
    };
    return {component(0), component(10), component(20)};
}

/// Blends neighbouring lattice values with two continuous derivatives (Perlin 2002, "Improving noise").
float fade(float t) {
    return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

Vector3 value_noise(const Vector3& p, std::uint32_t seed) {
    const Vector3 cell = p.array().floor();
    const int x = static_cast<int>(cell.x()), y = static_cast<int>(cell.y()), z = static_cast<int>(cell.z());
    const Vector3 t = p - cell;
    const float u = fade(t.x()), v = fade(t.y()), w = fade(t.z());
    const auto along_x = [&](int dy, int dz) -> Vector3 {
        const Vector3 near = lattice_value(x, y + dy, z + dz, seed);
        return near + u * (lattice_value(x + 1, y + dy, z + dz, seed) - near);
    };
    const auto along_y = [&](int dz) -> Vector3 {
        const Vector3 near = along_x(0, dz);
        return near + v * (along_x(1, dz) - near);
    };
    const Vector3 near = along_y(0);
    return near + w * (along_y(1) - near);
}

/// Of value_noise plus half of a second octave: 1 / sqrt(1.25 * 1/3 * s^3), s = 181/231 being the mean of
/// fade(t)^2 + fade(1 - t)^2 over a cell.
constexpr float to_unit_variance = 2.2333f;

/// Metres to lattice coordinates in [0, period), in double before the cast.
float lattice_offset(double metres, float scale) {
    const double cells = std::fmod(metres * static_cast<double>(scale), static_cast<double>(period));
    return static_cast<float>(cells < 0 ? cells + period : cells);
}

}  // namespace

WindField::WindField(const Wind& wind, const std::array<double, 3>& carried, double time)
    : mean_(to_vector(wind.velocity)),
      amplitude_(wind.gust * mean_.norm()),
      still_(amplitude_ == 0),
      octaves_{} {
    // The octaves drift apart at a tenth of the wind's speed, across it, so that the pattern never repeats as
    // it passes.
    const double drift = 0.1 * static_cast<double>(mean_.norm()) * time;
    for (std::uint32_t o = 0; o < octaves_.size(); ++o) {
        const float scale = static_cast<float>(o + 1) / wind.gust_length;
        const double rise = o == 0 ? drift : -drift;
        octaves_[o] = {
            .scale = scale,
            .offset = {lattice_offset(-carried[0], scale), lattice_offset(-carried[1] + rise, scale),
                       lattice_offset(-carried[2], scale)},
            .seed = wind.seed * 2 + o};
    }
}

Vector3 WindField::eddies(const Vector3& point) const {
    Vector3 sum = Vector3::Zero();
    float weight = to_unit_variance;
    for (const Octave& octave : octaves_) {
        sum += weight * value_noise(point * octave.scale + octave.offset, octave.seed);
        weight *= 0.5f;
    }
    return sum;
}

}  // namespace weft
