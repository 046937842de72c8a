// Particles that meet colliders on their way, and are elsewhere when the substep ends.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>

#include <Eigen/Geometry>

#include "collision/colliders/collider_contacts.h"
#include "collision/colliders/nearest_surface.h"
#include "tests/collision/colliders/swept_way.h"
#include "tests/collision/particle_cloud.h"

namespace weft::test {
namespace {

/// A capsule along its own x.
struct Bar {
    float half_length, radius;
    [[nodiscard]] Collider at(const Placed& place) const {
        return {Capsule{to_vec3(place({-half_length, 0, 0})), to_vec3(place({half_length, 0, 0})), radius},
                0.3f};
    }
    /// Of a point in its own space from the surface.
    [[nodiscard]] float distance(const Vector3& p) const {
        return (p - Vector3(std::clamp(p.x(), -half_length, half_length), 0, 0)).norm() - radius;
    }
};

/// As the bar sees it: least distance along the straight way.
float nearest_on_way(const Bar& bar, const Vector3& from, const Vector3& to) {
    float least = inf;
    for (int k = 0; k <= 400; ++k)
        least = std::min(least, bar.distance(from + static_cast<float>(k) / 400.0f * (to - from)));
    return least;
}

struct Flight {
    Bar bar{};
    Placed start, end;
    Particles particles;
    std::vector<Vec4> starts;
    [[nodiscard]] ColliderMotion motion() const { return {bar.at(start), bar.at(end)}; }
    [[nodiscard]] Vector3 seen_at_start(std::size_t i) const {
        return start.turn.conjugate() * (xyz(starts[i]) - start.origin);
    }
    [[nodiscard]] Vector3 seen_at_end(const Vec4& p) const {
        return end.turn.conjugate() * (xyz(p) - end.origin);
    }
};

/// Particles that start outside a bar that moves by up to 0.4 m and turns by up to a radian about any axis
/// across it, and that fly, too.
Flight random_flight(std::uint32_t seed, std::size_t n) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-1, 1);
    const auto vector = [&](float size) -> Vector3 {
        return size * Vector3(uniform(random), uniform(random), uniform(random));
    };
    Flight flight;
    flight.bar = {0.05f + 0.3f * (uniform(random) + 1), 0.02f + 0.02f * (uniform(random) + 1)};
    flight.start = {Eigen::Quaternionf(Eigen::AngleAxisf(3 * uniform(random), vector(1).normalized())),
                    vector(0.2f)};
    // About an axis across the bar: how a capsule spins about itself cannot be told from its ends.
    const Vector3 across = flight.start.turn * Vector3(0, uniform(random), uniform(random)).normalized();
    flight.end = {Eigen::Quaternionf(Eigen::AngleAxisf(uniform(random), across)) * flight.start.turn,
                  flight.start.origin + vector(0.4f)};
    while (flight.starts.size() < n) {
        const Vector3 from = vector(0.6f);
        flight.starts.push_back(to_vec4(from, 1));
        if (flight.bar.distance(flight.seen_at_start(flight.starts.size() - 1)) <= thickness) {
            flight.starts.pop_back();
            continue;
        }
        const Vector3 to = from + vector(0.3f);
        flight.particles.positions.push_back(to_vec4(to, 1));
        flight.particles.velocities.push_back(to_vec4(Vector3((to - from) / h), 0));
    }
    return flight;
}

TEST(SweptContacts, NothingPassesABarThatMovesAndTurns) {
    std::size_t passes = 0, misses = 0;
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        Flight flight = random_flight(seed, 300);
        const Particles before = flight.particles;
        meet_on_the_way(flight.particles, flight.starts, flight.motion());
        const float thin = 0.5f * (flight.bar.radius + thickness);
        for (std::size_t i = 0; i < flight.starts.size(); ++i) {
            const Vector3 from = flight.seen_at_start(i), to = flight.seen_at_end(before.positions[i]);
            if ((to - from).norm() < 1.01f * thin) continue;
            const float would = nearest_on_way(flight.bar, from, to);
            const float is =
                nearest_on_way(flight.bar, from, flight.seen_at_end(flight.particles.positions[i]));
            EXPECT_GT(is, thickness - 0.06f * thin) << seed << ' ' << i;
            if (would > thickness + 0.06f * thin) {
                EXPECT_EQ(xyz(before.positions[i]), xyz(flight.particles.positions[i])) << seed << ' ' << i;
                ++misses;
            } else if (would < 0 && flight.bar.distance(to) > thickness) {
                ++passes;
            }
        }
    }
    EXPECT_GT(passes, 60u);
    EXPECT_GT(misses, 3000u);
}

TEST(SweptContacts, ABarCarriesWhatItPassedAtItsOwnSpeed) {
    const Bar bar{1, 0.005f};
    const Placed end{Eigen::Quaternionf::Identity(), {0, 0, 0.5f}};
    Particles particles{{{0.3f, 0, 0.1f, 1}, {0.3f, 0, 0.1f, 0}, {0.3f, 0.02f, 0.1f, 1}},
                        std::vector<Vec4>(3)};
    const std::vector<Vec4> starts = particles.positions;
    EXPECT_EQ(meet_on_the_way(particles, starts, {bar.at({}), bar.at(end)}), 1u);
    EXPECT_NEAR(particles.positions[0].z, 0.5f + bar.radius + thickness, 1e-5f);
    EXPECT_NEAR(particles.velocities[0].z, 0.5f / h, 1e-2f);
    EXPECT_EQ(xyz(particles.positions[1]), xyz(starts[1]));  // pinned
    EXPECT_EQ(xyz(particles.positions[2]), xyz(starts[2]));  // beside its way
}

TEST(SweptContacts, WhatGrowsOrStretchesMeetsWhatItPasses) {
    Particles particles{{{0, 0.3f, 0, 1}}, {{}}};
    const std::vector<Vec4> starts = particles.positions;
    meet_on_the_way(particles, starts, {{Sphere{{0, 0, 0}, 0.1f}, 0}, {Sphere{{0, 0, 0}, 0.5f}, 0}});
    EXPECT_NEAR(particles.positions[0].y, 0.5f + thickness, 1e-5f);
    EXPECT_NEAR(particles.velocities[0].y, 0.4f / h, 1e-2f);

    particles = {{{0, 0.3f, 0, 1}}, {{}}};
    meet_on_the_way(
        particles, starts,
        {{Capsule{{0, -1, 0}, {0, 0, 0}, 0.02f}, 0}, {Capsule{{0, -1, 0}, {0, 0.5f, 0}, 0.02f}, 0}});
    EXPECT_GT(std::hypot(particles.positions[0].x, particles.positions[0].y - 0.5f, particles.positions[0].z),
              0.02f + 0.9f * thickness);
}

TEST(SweptContacts, ABarAtRestStopsWhatFliesThroughIt) {
    const Bar bar{1, 0.005f};
    Particles particles{{{0, 0, -0.2f, 1}}, {{0, 0, -0.4f / h, 0}}};
    meet_on_the_way(particles, {{0, 0, 0.2f, 1}}, {bar.at({}), bar.at({})});
    EXPECT_NEAR(particles.positions[0].z, bar.radius + thickness, 1e-5f);
    EXPECT_NEAR(particles.velocities[0].z, 0, 1e-3f);
}

TEST(SweptContacts, WhatIsOutsideOfAShapeThatGrowsComesFromOutside) {
    Particles particles{{{0, 0, 0.12f, 1}}, {{}}};
    const std::vector<Vec4> starts = particles.positions;
    meet_on_the_way(particles, starts, {{Sphere{{0, 0, 0}, 0.1f}, 0}, {Sphere{{0, 0, 1}, 0.3f}, 0}});
    EXPECT_NEAR(particles.positions[0].z, 1.3f + thickness, 1e-5f);
}

TEST(SweptContacts, WhatBeginsDeepInsideIsNotTakenAlong) {
    const Bar bar{1, 0.02f};
    Particles particles{{{0, 0, 0.002f, 1}}, {{}}};
    const std::vector<Vec4> starts = particles.positions;
    EXPECT_EQ(meet_on_the_way(particles, starts,
                              {bar.at({}), bar.at({Eigen::Quaternionf::Identity(), {0, 0, 0.1f}})}),
              0u);
}

TEST(SweptContacts, WhatIsFasterThanAnythingMayMoveSweepsNothing) {
    const Bar bar{1, 0.005f};
    expect_jumps_sweep_nothing({bar.at({}), bar.at({Eigen::Quaternionf::Identity(), {0, 0, 0.5f}})});
}

TEST(SweptContacts, WhatMovesLittleEndsWhereItDidWithoutALookAtItsWay) {
    const Bar bar{0.5f, 0.1f};
    const ColliderMotion motion{bar.at({}), bar.at({Eigen::Quaternionf::Identity(), {0.01f, 0.02f, 0}})};
    Particles swept = cloud(3000);
    const std::vector<Vec4> starts = swept.positions;
    Particles plain = swept;
    EXPECT_GT(meet(plain, {motion}, thickness, 0), 5u);
    meet_on_the_way(swept, starts, motion);
    for (std::size_t i = 0; i < starts.size(); ++i) {
        if (nearest_surface(bar.at({}), xyz(starts[i])).distance < thickness) continue;  // comes out in time
        EXPECT_EQ(std::memcmp(&swept.positions[i], &plain.positions[i], sizeof(Vec4)), 0) << i;
        EXPECT_EQ(std::memcmp(&swept.velocities[i], &plain.velocities[i], sizeof(Vec4)), 0) << i;
    }
}

TEST(SweptContacts, AheadOfTheSolverThePassedSurfaceIsOneThatHoldsTheParticle) {
    const Bar bar{1, 0.005f};
    const std::vector<ColliderMotion> motions{
        {bar.at({}), bar.at({Eigen::Quaternionf::Identity(), {0, 0, 0.5f}})}};
    Particles particles = cloud(block_size);
    for (std::size_t i = 0; i < block_size; ++i)
        particles.positions[i] = {-0.5f + static_cast<float>(i) / block_size, 0, 0.1f, 1};
    const float gamma = 0.01f;
    const float reach = 0.004f;
    NearSurfaces near;
    ASSERT_TRUE(find_near_surfaces(motions, EvenSide(block_size, thickness, 1), h, reach, particles.positions,
                                   particles.positions, gamma, particles.velocities, near));
    for (std::size_t i = 0; i < block_size; ++i) {
        const Vector3 p(near.points.x[i], near.points.y[i], near.points.z[i]);
        const Vector3 n(near.surfaces.x[i], near.surfaces.y[i], near.surfaces.z[i]);
        EXPECT_GT(n.z(), 0.5f);
        EXPECT_NEAR(near.surfaces.w[i], n.dot(p - Vector3(p.x(), 0, 0.5f)) - bar.radius - thickness, 1e-4f);
        EXPECT_NEAR(near.motions.z[i], 0.5f / h, 1e-2f);
    }
}

TEST(SweptContacts, ASubstepIsCutInPartsByHowFarWhatIsNearGoesAgainstAThinBar) {
    const Bar bar{1, 0.005f};  // its radius and the thickness are 15 mm
    const auto parts = [&](float way, const Vec4& particle, float speed) {
        const std::vector<ColliderMotion> motions{
            {bar.at({}), bar.at({Eigen::Quaternionf::Identity(), {0, 0, way}})}};
        const std::vector<Vec4> positions(16, particle), velocities(16, Vec4{0, 0, speed, 0});
        Parallel parallel(1);
        std::vector<std::uint32_t> partials(1);
        return parts_to_meet(parallel, motions, EvenSide(16, thickness, 1), h, 8, positions, velocities,
                             partials);
    };
    const Vec4 before{0, 0, 0.02f, 1};
    EXPECT_EQ(parts(0.007f, {0, 0, 0.005f, 1}, 0), 1u);  // slow
    EXPECT_EQ(parts(0.04f, before, 0), 3u);
    EXPECT_EQ(parts(0.5f, before, 0), 8u);
    EXPECT_EQ(parts(0.5f, {0, 0.1f, 0.02f, 1}, 0), 1u);         // beside it
    EXPECT_EQ(parts(0.5f, {0, 0, 0.02f, 0}, 0), 1u);            // pinned
    EXPECT_EQ(parts(0.04f, {0, 0, 0.014f, 1}, 0.04f / h), 1u);  // goes along
}

TEST(SweptContacts, WhatIsNotANumberHidesNothing) {
    const Bar bar{1, 0.005f};
    const Placed end{Eigen::Quaternionf::Identity(), {0, 0, 0.5f}};
    for (const float value : {nan, inf}) {
        Particles particles{std::vector<Vec4>(40, Vec4{value, 0, 0.1f, 1}), std::vector<Vec4>(40)};
        particles.positions[5] = particles.positions[37] = {0, 0, 0.1f, 1};
        std::vector<Vec4> starts = particles.positions;
        starts[7] = {0, 0, 0.1f, 1};
        EXPECT_EQ(meet_on_the_way(particles, starts, {bar.at({}), bar.at(end)}), 2u);
        EXPECT_NEAR(particles.positions[37].z, 0.515f, 1e-5f);
    }
}

}  // namespace
}  // namespace weft::test
