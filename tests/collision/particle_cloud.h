#pragma once
// Particles that meet colliders.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "collision/thin/collide.h"

namespace weft::test {

inline constexpr float h = 1.0f / 120;
inline constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                       inf = std::numeric_limits<float>::infinity();

struct Particles {
    std::vector<Vec4> positions, velocities;
};

/// The side of a cloth whose particles are all alike.
class EvenSide {
  public:
    EvenSide(std::size_t size, float thickness, float friction)
        : thickness_(size), friction_(size), most_(thickness) {
        std::ranges::fill(thickness_.span(), thickness);
        std::ranges::fill(friction_.span(), friction);
    }
    operator ClothSide() const {  // NOLINT: tests give it where a ClothSide is asked for
        return {.thickness = thickness_.span(), .friction = friction_.span(), .most_thickness = most_};
    }

  private:
    AlignedBuffer<float> thickness_, friction_;
    float most_;
};

inline std::uint32_t meet(Particles& particles, const std::vector<ColliderMotion>& colliders, float thickness,
                          float friction = 1, int threads = 1) {
    Parallel parallel(threads);
    std::vector<std::uint32_t> partials(block_count(static_cast<std::uint32_t>(particles.positions.size())));
    return collide(parallel, colliders, EvenSide(particles.positions.size(), thickness, friction), h,
                   {.positions = particles.positions, .velocities = particles.velocities}, partials);
}

inline ColliderMotion at_rest(const Collider& collider) {
    return {collider, collider};
}

inline Particles cloud(std::size_t n) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(-1, 1);
    Particles particles;
    for (std::size_t i = 0; i < n; ++i) {
        particles.positions.push_back({uniform(random), uniform(random), uniform(random), 1});
        particles.velocities.push_back({uniform(random), uniform(random), uniform(random), 0});
    }
    return particles;
}

}  // namespace weft::test
