#include "collision/particles/velocity_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engine/memory/aligned_buffer.h"
#include "particle_cloud.h"

namespace weft::test {
namespace {

std::uint32_t filter(Particles& particles, const std::vector<ColliderMotion>& colliders, int threads = 1) {
    Parallel parallel(threads);
    AlignedBuffer<Vec4> positions(particles.positions.size()), velocities(particles.positions.size());
    std::ranges::copy(particles.positions, positions.data());
    std::ranges::copy(particles.velocities, velocities.data());
    std::vector<std::uint32_t> partials(block_count(static_cast<std::uint32_t>(positions.size())));
    const std::uint32_t inside =
        filter_velocities(parallel, colliders, {}, h, positions.span(), velocities.span(), partials);
    std::ranges::copy(velocities.span(), particles.velocities.begin());
    return inside;
}

TEST(VelocityFilter, TakesWhatGoesFartherInAndNothingElse) {
    // As the source states it, one particle at a time: a sphere at rest.
    const Vector3 center(0.1f, -0.2f, 0.05f);
    const float radius = 0.7f;
    const Collider sphere{.shape = Sphere{to_vec3(center), radius}, .friction = 5};
    Particles particles = cloud(1000);
    for (std::size_t i = 0; i < 1000; i += 9) particles.positions[i].w = 0;
    const Particles before = particles;
    const std::uint32_t inside = filter(particles, {at_rest(sphere)});
    std::uint32_t expected_inside = 0, stopped = 0;
    for (std::size_t i = 0; i < 1000; ++i) {
        const Vec4 &p = before.positions[i], &q = particles.positions[i];
        EXPECT_TRUE(p.x == q.x && p.y == q.y && p.z == q.z && p.w == q.w) << "positions stay";
        const Vector3 v = xyz(before.velocities[i]), n = (xyz(p) - center).normalized();
        const bool is_inside = (xyz(p) - center).norm() < radius && p.w > 0;
        expected_inside += is_inside ? 1 : 0;
        const bool goes_in = is_inside && n.dot(v) < 0;
        stopped += goes_in ? 1 : 0;
        const Vector3 expected = goes_in ? Vector3(v - n * n.dot(v)) : v;
        EXPECT_LT((xyz(particles.velocities[i]) - expected).norm(), goes_in ? 1e-6f : 1e-30f) << i;
    }
    EXPECT_EQ(inside, expected_inside);
    EXPECT_GT(stopped, 50u);
    EXPECT_LT(stopped, inside);
}

TEST(VelocityFilter, IsOfTheVelocityRelativeToTheSurface) {
    // A plate that rises at 2 m/s: what it has overtaken goes on as fast, and slides as it did.
    const auto plate = [](float y) { return Collider{.shape = Plane{{0, 1, 0}, y}, .friction = 1}; };
    Particles particles{{{0, 0.5f, 0, 1}, {0, 0.5f, 0, 1}, {0, 1.5f, 0, 1}},
                        {{3, 0, 0, 0}, {3, 2.5f, 0, 0}, {3, 0, 0, 0}}};
    EXPECT_EQ(filter(particles, {{plate(1 - 2 * h), plate(1)}}), 2u);
    EXPECT_NEAR(particles.velocities[0].y, 2, 1e-4);
    EXPECT_EQ(particles.velocities[0].x, 3);
    EXPECT_EQ(particles.velocities[1].y, 2.5f);
    EXPECT_EQ(particles.velocities[2].y, 0);
}

}  // namespace
}  // namespace weft::test
