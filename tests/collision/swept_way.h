#pragma once
// Particles and colliders that move within a substep.

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "engine/vector.h"
#include "particle_cloud.h"

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
    return collide(parallel, {&motion, 1}, thickness, 0, h, {}, starts, particles.positions,
                   particles.velocities, partials);
}

}  // namespace weft::test
