#pragma once
// A crumpled sheet and other particle sets, the same at every run.

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "collision/particles/self_contacts.h"
#include "weft/types.h"

namespace weft::test {

/// Particles now and at rest, and which are joined. positions.w = 1.
struct Sheet {
    std::vector<Vec4> positions, rest;
    std::vector<std::uint32_t> offsets, neighbours;

    [[nodiscard]] RestFilter filter() const { return {offsets, neighbours}; }
};

inline Bounds bounds_of(const std::vector<Vec4>& positions) {
    Bounds bounds{{1e30f, 1e30f, 1e30f}, {-1e30f, -1e30f, -1e30f}};
    for (const Vec4& p : positions) {
        bounds.lower = {std::fmin(bounds.lower.x, p.x), std::fmin(bounds.lower.y, p.y),
                        std::fmin(bounds.lower.z, p.z)};
        bounds.upper = {std::fmax(bounds.upper.x, p.x), std::fmax(bounds.upper.y, p.y),
                        std::fmax(bounds.upper.z, p.z)};
    }
    return bounds;
}

/// side * side particles, one spacing of `1 / side` apart at rest, joined along the threads and the
/// diagonals, and bent over one another by waves of random direction. Some ten contacts per hundred particles
/// at 0.75 of the spacing.
inline Sheet crumpled_sheet(std::uint32_t side, std::uint32_t seed = 1) {
    Sheet sheet;
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-1, 1);

    struct Wave {
        float along_u, along_v, phase;
        Vec4 amplitude;
    };
    std::vector<Wave> waves(24);
    for (std::size_t k = 0; k < waves.size(); ++k) {
        const float frequency = 4.0f + 1.5f * static_cast<float>(k);
        const float angle = 3.14159265f * uniform(random);
        const float size = 1.1f / frequency;
        waves[k] = {frequency * std::cos(angle),
                    frequency * std::sin(angle),
                    3.14159265f * uniform(random),
                    {size * uniform(random), size * uniform(random), size * uniform(random), 0}};
    }

    const float spacing = 1.0f / static_cast<float>(side);
    for (std::uint32_t row = 0; row < side; ++row) {
        for (std::uint32_t column = 0; column < side; ++column) {
            const float u = spacing * static_cast<float>(column), v = spacing * static_cast<float>(row);
            Vec4 p{0.2f * u, 0, 0.2f * v, 1};
            for (const Wave& wave : waves) {
                const float height = std::sin(wave.along_u * u + wave.along_v * v + wave.phase);
                p.x += wave.amplitude.x * height;
                p.y += wave.amplitude.y * height;
                p.z += wave.amplitude.z * height;
            }
            sheet.positions.push_back(p);
            sheet.rest.push_back({u, 0, v, 0});
        }
    }

    const auto last = static_cast<std::int64_t>(side);
    sheet.offsets.push_back(0);
    for (std::int64_t row = 0; row < last; ++row) {
        for (std::int64_t column = 0; column < last; ++column) {
            for (std::int64_t dr = -1; dr <= 1; ++dr) {
                for (std::int64_t dc = -1; dc <= 1; ++dc) {
                    const std::int64_t r = row + dr, c = column + dc;
                    if ((dr == 0 && dc == 0) || r < 0 || c < 0 || r >= last || c >= last) continue;
                    sheet.neighbours.push_back(static_cast<std::uint32_t>(r * last + c));
                }
            }
            sheet.offsets.push_back(static_cast<std::uint32_t>(sheet.neighbours.size()));
        }
    }
    return sheet;
}

}  // namespace weft::test
