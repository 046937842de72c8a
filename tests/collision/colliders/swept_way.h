#pragma once
// Particles and colliders that move within a substep.

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "collision/thin/collide.h"
#include "engine/vector.h"
#include "tests/collision/particle_cloud.h"

namespace weft::test {

inline constexpr float thickness = 0.01f;

/// Rigid, from the start to the end of a substep.
struct Placed {
    Eigen::Quaternionf turn = Eigen::Quaternionf::Identity();
    Vector3 origin = Vector3::Zero();
    [[nodiscard]] Vector3 operator()(const Vector3& p) const { return origin + turn * p; }
    [[nodiscard]] Vector3 back(const Vector3& p) const { return turn.conjugate() * (p - origin); }
};

inline std::uint32_t meet_on_the_way(Particles& particles, const std::vector<Vec4>& starts,
                                     const ColliderMotion& motion, int threads = 1) {
    Parallel parallel(threads);
    std::vector<std::uint32_t> partials(block_count(static_cast<std::uint32_t>(starts.size())));
    return collide(parallel, {&motion, 1}, EvenSide(starts.size(), thickness, 0), h,
                   {.positions = particles.positions, .velocities = particles.velocities, .starts = starts},
                   partials);
}

/// Of a collider that goes 0.5 m over a particle 0.1 m ahead: nothing may be as fast, or just may.
inline void expect_jumps_sweep_nothing(ColliderMotion motion) {
    for (const float part : {0.99f, 1.01f}) {
        Particles particles{{{0, 0, 0.1f, 1}}, {{}}};
        const std::vector<Vec4> starts = particles.positions;
        motion.fastest = 0.5f / h / part;
        EXPECT_EQ(meet_on_the_way(particles, starts, motion), part < 1 ? 1u : 0u);
    }
}

}  // namespace weft::test
