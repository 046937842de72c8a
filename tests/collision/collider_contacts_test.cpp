#include "collision/collider_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include "collider_reference.h"
#include "engine/error_text.h"

namespace weft::test {
namespace {

constexpr float h = 1.0f / 120, gravity = 9.81f;
constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();

struct Particles {
    std::vector<Vec4> positions, velocities;
};

std::uint32_t meet(Particles& particles, const std::vector<ColliderMotion>& colliders, float thickness,
                   float friction = 1, int threads = 1) {
    Parallel parallel(threads);
    std::vector<std::uint32_t> partials(block_count(static_cast<std::uint32_t>(particles.positions.size())));
    return collide(parallel, colliders, thickness, friction, h, {}, particles.positions, particles.velocities,
                   partials);
}

ColliderMotion at_rest(const Collider& collider) {
    return {collider, collider};
}

Particles cloud(std::size_t n) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(-1, 1);
    Particles particles;
    for (std::size_t i = 0; i < n; ++i) {
        particles.positions.push_back({uniform(random), uniform(random), uniform(random), 1});
        particles.velocities.push_back({uniform(random), uniform(random), uniform(random), 0});
    }
    return particles;
}

/// Particles nearer than the thickness end on it, all others are as they were. `distance`: the shape's signed
/// distance.
template <class Distance>
void expect_pushed_to_surface(const Collider& collider, const Distance& distance) {
    const float thickness = 0.05f;
    const Particles before = cloud(2000);
    Particles after = before;
    const std::uint32_t met = meet(after, {at_rest(collider)}, thickness, 0);
    std::uint32_t expected = 0;
    for (std::size_t i = 0; i < before.positions.size(); ++i) {
        if (distance(before.positions[i]) >= thickness) {
            EXPECT_EQ(xyz(after.positions[i]), xyz(before.positions[i]));
            EXPECT_EQ(xyz(after.velocities[i]), xyz(before.velocities[i]));
        } else {
            ++expected;
            EXPECT_NEAR(distance(after.positions[i]), thickness, 1e-5f);
        }
    }
    EXPECT_EQ(met, expected);
    EXPECT_GT(met, 20u);
    EXPECT_LT(met, 1980u);
}

TEST(Colliders, SphereKeepsParticlesAtItsSignedDistance) {
    expect_pushed_to_surface({Sphere{{0.1f, 0.2f, -0.1f}, 0.5f}, 0.4f}, [](const Vec4& p) {
        return std::hypot(p.x - 0.1f, p.y - 0.2f, p.z + 0.1f) - 0.5f;
    });
}

TEST(Colliders, CapsuleKeepsParticlesAtItsSignedDistance) {
    const Vector3 a(-0.6f, 0.1f, 0), b(0.3f, -0.2f, 0.5f);
    expect_pushed_to_surface({Capsule{to_vec3(a), to_vec3(b), 0.3f}, 0.4f}, [&](const Vec4& p) {
        float nearest = inf;  // over spheres along the axis, without the formula under test
        for (int k = 0; k <= 2000; ++k) {
            nearest =
                std::min(nearest, (xyz(p) - (a + static_cast<float>(k) / 2000.0f * (b - a))).squaredNorm());
        }
        return std::sqrt(nearest) - 0.3f;
    });
}

TEST(Colliders, PlaneKeepsParticlesAtItsSignedDistance) {
    expect_pushed_to_surface({Plane{{3, 4, 0}, -0.2f}, 0.4f},
                             [](const Vec4& p) { return 0.6f * p.x + 0.8f * p.y + 0.2f; });
}

TEST(Colliders, ApproachIsTakenAwayAndSeparationIsLeft) {
    Particles particles{{{0, 0.5f, 0, 1}, {0, 0.5f, 0, 1}}, {{0.3f, -2, 0, 0}, {0.3f, 2, 0, 0}}};
    meet(particles, {at_rest({Sphere{{0, 0, 0}, 0.6f}, 0.4f})}, 0, 0);
    EXPECT_NEAR(particles.velocities[0].y, 0, 1e-6f);
    EXPECT_FLOAT_EQ(particles.velocities[0].x, 0.3f);
    EXPECT_FLOAT_EQ(particles.velocities[1].y, 2);
}

TEST(Colliders, PinnedParticlesAreLeftAndNotCounted) {
    Particles particles{{{0, 0, 0, 0}}, {{0, -1, 0, 0}}};
    EXPECT_EQ(meet(particles, {at_rest({Sphere{{0, 0, 0}, 1}, 0.4f})}, 0.1f), 0u);
    EXPECT_EQ(particles.positions[0].y, 0);
    EXPECT_EQ(particles.velocities[0].y, -1);
}

TEST(Colliders, ParticlesOnTheAxisLeaveByADefiniteWay) {
    const Collider sphere{Sphere{{1, 1, 1}, 0.5f}, 0.4f}, capsule{Capsule{{0, 0, 0}, {4, 0, 0}, 0.5f}, 0.4f};
    Particles particles{{{1, 1, 1, 1}}, {{}}};
    meet(particles, {at_rest(sphere)}, 0.1f);
    EXPECT_NEAR(particles.positions[0].y, 1.6f, 1e-6f);
    particles = {{{1, 0, 0, 1}}, {{}}};
    meet(particles, {at_rest(capsule)}, 0.1f);
    EXPECT_EQ(particles.positions[0].x, 1);
    EXPECT_NEAR(std::hypot(particles.positions[0].y, particles.positions[0].z), 0.6f, 1e-6f);
}

TEST(Colliders, ParticlesThatAreNotFiniteAreLeft) {
    Particles particles{{{nan, 0, 0, 1}, {inf, 0, 0, 1}}, {{}, {}}};
    const std::vector<ColliderMotion> all{at_rest({Sphere{{0, 0, 0}, 1}, 0.4f}),
                                          at_rest({Capsule{{0, 0, 0}, {1, 0, 0}, 1}, 0.4f}),
                                          at_rest({Plane{}, 0.4f})};
    EXPECT_EQ(meet(particles, all, 0.1f), 0u);
}

TEST(Colliders, AParticleThatMeetsTwoCountsOnce) {
    Particles particles{{{0, 0, 0, 1}}, {{}}};
    EXPECT_EQ(meet(particles, {at_rest({Plane{}, 0.4f}), at_rest({Sphere{{0, 0, 0}, 1}, 0.4f})}, 0.1f), 1u);
}

/// Where a particle that starts at rest on a slope is after `seconds`, down the slope.
float slid_down(float angle, float friction, float seconds) {
    const Vector3 normal(std::sin(angle), std::cos(angle), 0), down(std::cos(angle), -std::sin(angle), 0);
    const ColliderMotion slope = at_rest({Plane{to_vec3(normal), 0}, friction});
    Particles particles{{to_vec4(0.01f * normal, 1)}, {{}}};
    for (int step = 0; step < static_cast<int>(seconds / h); ++step) {
        particles.velocities[0].y -= h * gravity;
        set_xyz(particles.positions[0], xyz(particles.positions[0]) + h * xyz(particles.velocities[0]));
        meet(particles, {slope}, 0.01f);
    }
    return xyz(particles.positions[0]).dot(down);
}

TEST(Colliders, BelowTheFrictionAngleAParticleRestsAndDoesNotCreep) {
    EXPECT_NEAR(slid_down(std::atan(0.45f), 0.5f, 10), 0, 1e-4f);
    EXPECT_NEAR(slid_down(std::atan(0.1f), 0.5f, 10), 0, 1e-4f);
}

TEST(Colliders, AboveTheFrictionAngleItSlidesByCoulombsLaw) {
    for (const float friction : {0.0f, 0.3f}) {
        const float angle = 0.6f, seconds = 1;
        const float expected =
            0.5f * gravity * (std::sin(angle) - friction * std::cos(angle)) * seconds * seconds;
        EXPECT_NEAR(slid_down(angle, friction, seconds), expected, 0.02f * expected);
    }
}

TEST(Colliders, AMovingBeamDragsWhatRestsOnIt) {
    const float speed = 0.5f;
    Particles particles{{{0, 0.6f, 0, 1}}, {{}}};
    float beam = 0;
    for (int step = 0; step < 240; ++step) {
        const auto at = [&](float x) { return Collider{Capsule{{x - 5, 0, 0}, {x + 5, 0, 0}, 0.5f}, 0.4f}; };
        const ColliderMotion motion{at(beam), at(beam + h * speed)};
        beam += h * speed;
        particles.velocities[0].y -= h * gravity;
        set_xyz(particles.positions[0], xyz(particles.positions[0]) + h * xyz(particles.velocities[0]));
        meet(particles, {motion}, 0.1f);
    }
    EXPECT_NEAR(particles.velocities[0].x, speed, 1e-3f);
    // It slipped while it gained speed at friction * gravity, for speed^2 / (2 friction gravity), and then no
    // more.
    EXPECT_NEAR(beam - particles.positions[0].x, speed * speed / (2 * 0.4f * gravity), 0.005f);
}

TEST(Colliders, AMovingSpherePushesAtItsSpeed) {
    Particles particles{{{1, 0, 0, 1}}, {{}}};
    const float speed = 3;
    meet(particles, {{{Sphere{{0, 0, 0}, 1}, 0.4f}, {Sphere{{h * speed, 0, 0}, 1}, 0.4f}}}, 0.01f);
    EXPECT_NEAR(particles.velocities[0].x, speed, 1e-4f);
    EXPECT_NEAR(particles.positions[0].x, 1.01f + h * speed, 1e-6f);
}

TEST(Colliders, AGrowingSphereASwingingCapsuleAndATurningPlanePushAtTheirSurfacesSpeed) {
    Particles particles{{{0, 1, 0, 1}}, {{}}};
    meet(particles, {{{Sphere{{0, 0, 0}, 1}, 0}, {Sphere{{0, 0, 0}, 1 + h * 2}, 0}}}, 0);
    EXPECT_NEAR(particles.velocities[0].y, 2, 1e-3f);

    particles = {{{0.5f, 0.1f, 0, 1}}, {{}}};  // half way from the still end to the one that rises at 4 m/s
    meet(particles,
         {{{Capsule{{0, 0, 0}, {1, 0, 0}, 0.1f}, 0}, {Capsule{{0, 0, 0}, {1, h * 4, 0}, 0.1f}, 0}}}, 0);
    EXPECT_NEAR(particles.velocities[0].y, 2, 0.05f);

    const float turn = h * 1.0f;  // 1 rad/s about z: at x = -2 the surface rises at 2 m/s
    particles = {{{-2, 0, 0, 1}}, {{}}};
    meet(particles, {{{Plane{{0, 1, 0}, 0}, 0}, {Plane{{std::sin(turn), std::cos(turn), 0}, 0}, 0}}}, 0);
    EXPECT_NEAR(particles.velocities[0].y, 2, 0.05f);
}

TEST(Colliders, ManyAtATimeDoAsOneByOne) {
    const std::vector<ColliderMotion> all{
        {{Sphere{{0, 0, 0}, 0.5f}, 0.4f}, {Sphere{{0.01f, 0, 0.02f}, 0.51f}, 0.4f}},
        {{Capsule{{-1, 0.4f, 0}, {1, 0.5f, 0}, 0.2f}, 0.2f},
         {Capsule{{-1, 0.42f, 0}, {1, 0.5f, 0.02f}, 0.2f}, 0.2f}},
        {{Plane{{0, 1, 0.1f}, -0.5f}, 0.9f}, {Plane{{0, 2, 0.21f}, -0.49f}, 0.9f}},
        at_rest({Sphere{{7, 7, 7}, 0.5f}, 0.4f}),
        at_rest({Plane{{1, 0, 0}, -3}, 0.4f})};
    for (const std::size_t n : {1u, 15u, 16u, 300u, 1037u}) {
        for (const float friction : {0.0f, 0.3f, 5.0f}) {
            Particles expected = cloud(n);
            for (std::size_t i = 0; i < n; i += 5) expected.positions[i].w = 0;
            Particles several = expected;
            std::uint32_t expected_to_meet = 0;
            for (std::size_t i = 0; i < n; ++i) {
                bool met = false;
                for (const ColliderMotion& motion : all) {
                    met |= reference_collide(motion, 0.02f, friction, h, expected.positions[i],
                                             expected.velocities[i]);
                }
                expected_to_meet += met ? 1 : 0;
            }
            EXPECT_EQ(meet(several, all, 0.02f, friction), expected_to_meet);
            for (std::size_t i = 0; i < n; ++i) {
                const Vec4 &x = several.positions[i], &v = several.velocities[i];
                ASSERT_LT((xyz(x) - xyz(expected.positions[i])).norm(), 2e-6f) << i << " of " << n;
                ASSERT_LT((xyz(v) - xyz(expected.velocities[i])).norm(), 1e-4f) << i << " of " << n;
                ASSERT_EQ(x.w, expected.positions[i].w);
            }
        }
    }
}

TEST(Colliders, WhatOneColliderPushesOutOfTheBlocksBoundsTheNextOneMeets) {
    const std::vector<ColliderMotion> all{at_rest({Sphere{{0, 0, 0}, 1}, 0}),
                                          at_rest({Sphere{{0, 1.2f, 0}, 0.3f}, 0})};
    for (const std::size_t n : {1u, 16u, 20u}) {
        Particles particles{std::vector<Vec4>(n, Vec4{0, 0.1f, 0, 1}), std::vector<Vec4>(n)};
        EXPECT_EQ(meet(particles, all, 0), n);
        for (const Vec4& p : particles.positions) EXPECT_NEAR(p.y, 0.9f, 1e-5f);
    }
}

TEST(Colliders, ParticlesThatAreNotFiniteDoNotHideOthersOfTheirBlock) {
    const std::vector<ColliderMotion> all{at_rest({Sphere{{0, 0, 0}, 1}, 0}), at_rest({Plane{}, 0})};
    for (const float value : {nan, inf, -inf}) {
        Particles particles{std::vector<Vec4>(50, Vec4{value, 5, value, 1}), std::vector<Vec4>(50)};
        particles.positions[3] = {0, 0.5f, 0, 1};
        particles.positions[49] = {3, -0.5f, 0, 1};
        EXPECT_EQ(meet(particles, all, 0), 2u);
        EXPECT_NEAR(particles.positions[3].y, 1, 1e-6f);
        EXPECT_NEAR(particles.positions[49].y, 0, 1e-6f);
    }
}

TEST(Colliders, BytesAreTheSameForAnyNumberOfThreads) {
    const std::vector<ColliderMotion> all{
        {{Sphere{{0, 0, 0}, 0.5f}, 0.4f}, {Sphere{{0.01f, 0, 0}, 0.5f}, 0.4f}},
        {{Capsule{{0, 0, 0}, {1, 0, 0}, 0.3f}, 0.2f}, {Capsule{{0, 0, 0}, {1, 0.02f, 0}, 0.3f}, 0.2f}},
        at_rest({Plane{{0, 1, 0}, -0.3f}, 0.9f})};
    Particles one = cloud(5000);
    const std::uint32_t met = meet(one, all, 0.02f, 0.7f, 1);
    for (const int threads : {2, 3, 8}) {
        Particles several = cloud(5000);
        EXPECT_EQ(meet(several, all, 0.02f, 0.7f, threads), met);
        const std::size_t bytes = one.positions.size() * sizeof(Vec4);
        EXPECT_EQ(std::memcmp(several.positions.data(), one.positions.data(), bytes), 0);
        EXPECT_EQ(std::memcmp(several.velocities.data(), one.velocities.data(), bytes), 0);
    }
}

TEST(Colliders, ValidateNamesTheBadValue) {
    const auto expect_names = [](const Collider& collider, const std::string& name,
                                 const std::string& value) {
        const Result<void> result = validate(collider);
        ASSERT_FALSE(result.ok()) << name;
        EXPECT_EQ(result.error().code, ErrorCode::invalid_argument);
        EXPECT_NE(result.error().message.find(name), std::string::npos) << result.error().message;
        EXPECT_NE(result.error().message.find(value), std::string::npos) << result.error().message;
    };
    expect_names({Sphere{{0, nan, 0}, 1}, 0.4f}, "Sphere::center", "nan");
    expect_names({Sphere{{0, 0, 0}, 0}, 0.4f}, "Sphere::radius", "0");
    expect_names({Sphere{{0, 0, 0}, inf}, 0.4f}, "Sphere::radius", "inf");
    expect_names({Capsule{{0, inf, 0}, {0, 0, 0}, 1}, 0.4f}, "Capsule::a", "inf");
    expect_names({Capsule{{0, 0, 0}, {0, 0, nan}, 1}, 0.4f}, "Capsule::b", "nan");
    expect_names({Capsule{{0, 0, 0}, {0, 0, 0}, -2}, 0.4f}, "Capsule::radius", "-2");
    expect_names({Plane{{0, 0, 0}, 1}, 0.4f}, "Plane::normal", "0");
    expect_names({Plane{{0, nan, 0}, 1}, 0.4f}, "Plane::normal", "nan");
    expect_names({Plane{{0, 1, 0}, -inf}, 0.4f}, "Plane::offset", "-inf");
    expect_names({Sphere{}, -0.5f}, "Collider::friction", "-0.5");

    EXPECT_TRUE(validate({Sphere{}, 0}).ok());
    EXPECT_TRUE(validate({Capsule{}, 0.4f}).ok());  // a == b is a sphere
    EXPECT_TRUE(validate({Plane{{0, 20, 0}, -3}, 2}).ok());
}

TEST(Colliders, ValidateKnowsBothEndsOfEachRange) {
    const auto rejects = [](const Collider& collider, const std::string& value) {
        const Result<void> result = validate(collider);
        return !result.ok() && result.error().message.find(value) != std::string::npos;
    };
    for (const float radius : {1e-39f, 1e-7f, 1.1e5f, 1e30f}) {
        const std::string value = number_text(static_cast<double>(radius));
        EXPECT_TRUE(rejects({Sphere{{}, radius}, 0}, value)) << radius;
        EXPECT_TRUE(rejects({Capsule{{}, {1, 0, 0}, radius}, 0}, value)) << radius;
    }
    for (const float far : {1.1e5f, -1.1e5f, 1e30f}) {
        const std::string value = number_text(static_cast<double>(far));
        EXPECT_TRUE(rejects({Sphere{{0, far, 0}, 1}, 0}, value)) << far;
        EXPECT_TRUE(rejects({Capsule{{far, 0, 0}, {}, 1}, 0}, value)) << far;
        EXPECT_TRUE(rejects({Capsule{{}, {0, 0, far}, 1}, 0}, value)) << far;
        EXPECT_TRUE(rejects({Plane{{0, 1, 0}, far}, 0}, value)) << far;
    }
    for (const float length : {1e-39f, 1e-30f, 1e13f, 3e38f})
        EXPECT_TRUE(rejects({Plane{{0, length, 0}, 0}, 0}, number_text(static_cast<double>(length))));
    EXPECT_TRUE(rejects({Sphere{}, inf}, "inf"));
    EXPECT_TRUE(rejects({Sphere{}, nan}, "nan"));
    EXPECT_TRUE(rejects({Sphere{}, 1.1e6f}, "1100000"));
}

/// Every collider that validate() takes at the ends of its ranges.
std::vector<Collider> extreme_colliders() {
    std::vector<Collider> all;
    for (const float friction : {0.0f, 1e-40f, 1e6f}) {
        for (const float radius : {1e-6f, 0.3f, 1e5f}) {
            for (const Vec3 center : {Vec3{0, 0, 0}, Vec3{1e-40f, 0.1f, 0}, Vec3{1e5f, -1e5f, 1e5f}}) {
                all.push_back({Sphere{center, radius}, friction});
                all.push_back({Capsule{center, center, radius}, friction});
                for (const float axis : {1e-40f, 1e-20f, 1e-7f, 1.0f, 1e5f})
                    all.push_back({Capsule{center, {axis, 0, axis}, radius}, friction});
            }
        }
        for (const float length : {2e-12f, 1.0f, 9e11f})
            for (const float offset : {-1e5f, 1e-40f, 0.1f, 1e5f})
                for (const Vec3 normal : {Vec3{0, length, 0}, Vec3{0, -0.5f * length, 0.5f * length}})
                    all.push_back({Plane{normal, offset}, friction});
    }
    return all;
}

TEST(Colliders, NothingThatIsTakenMakesWhatIsNotFinite) {
    constexpr float fastest = 100;
    const std::vector<Collider> all = extreme_colliders();
    Particles start = cloud(48);
    for (std::size_t i = 0; i < 16; ++i)  // on axes, and all but on them
        start.positions[i] = {i % 4 == 0 ? 0 : 1e-22f * static_cast<float>(i), i % 3 == 0 ? 0.1f : 0, 0, 1};
    std::size_t met = 0;
    for (const Collider& from : all) {
        ASSERT_TRUE(validate(from).ok()) << validate(from).error().message;
        for (const Collider& to : all) {
            if (from.shape.index() != to.shape.index()) continue;
            Particles particles = start;
            const std::vector<ColliderMotion> motions{{from, to, fastest}};
            met += meet(particles, motions, 0.005f);
            for (std::size_t i = 0; i < particles.positions.size(); ++i) {
                ASSERT_TRUE(xyz(particles.positions[i]).allFinite() &&
                            xyz(particles.velocities[i]).allFinite());
                ASSERT_LT(xyz(particles.velocities[i]).norm(), 4 * fastest);
            }
            NearSurfaces near;
            if (!find_near_surfaces(motions, 0.005f, 1, h, 0.004f, start.positions, h, start.velocities,
                                    near))
                continue;
            for (std::size_t i = 0; i < start.positions.size(); ++i) {
                const Vector3 normal(near.surfaces.x[i], near.surfaces.y[i], near.surfaces.z[i]),
                    motion(near.motions.x[i], near.motions.y[i], near.motions.z[i]);
                ASSERT_TRUE(near.surfaces.w[i] >= 0.004f || std::abs(normal.norm() - 1) < 1e-4f);
                ASSERT_TRUE(std::isfinite(near.surfaces.w[i]) && motion.norm() < 3 * fastest);
            }
        }
    }
    EXPECT_GT(met, 10000u);
}

TEST(Colliders, OneThatJumpsMovesWhatItMeetsNoFasterThanItsFastest) {
    for (const float way : {10.0f, 100.0f, 1000.0f, 1e5f}) {
        for (const ColliderMotion& motion :
             {ColliderMotion{{Sphere{{way, 0, 0}, 1.5f}, 0.4f}, {Sphere{{0, 0, 0}, 1.5f}, 0.4f}, 100},
              ColliderMotion{{Capsule{{way, 0, 0}, {0, 0, way}, 1.5f}, 0.4f},
                             {Capsule{{-1, 0, 0}, {1, 0, 0}, 1.5f}, 0.4f},
                             100},
              ColliderMotion{{Plane{{0, 1, 0}, -way}, 0.4f}, {Plane{{0, 1, 0}, 1}, 0.4f}, 100},
              ColliderMotion{{Plane{{0, -1, 0}, way}, 0.4f}, {Plane{{0, 1, 0}, 1}, 0.4f}, 100}}) {
            const Particles before = cloud(500);
            Particles after = before;
            EXPECT_GT(meet(after, {motion}, 0.005f), 100u);
            for (std::size_t i = 0; i < before.positions.size(); ++i) {
                EXPECT_LE(xyz(after.velocities[i]).norm(), 103) << way;
                // Out of it, and rubbed along by a speed that is no greater.
                EXPECT_LT((xyz(after.positions[i]) - xyz(before.positions[i])).norm(), 3.5f + 103 * h) << way;
            }
        }
    }
}

TEST(Colliders, OfSeveralTheNearestSurfaceIsFoundWhateverTheirOrder) {
    std::vector<ColliderMotion> all{
        {{Sphere{{0, 0, 0}, 0.5f}, 0.4f}, {Sphere{{0.01f, 0, 0.02f}, 0.51f}, 0.4f}},
        {{Capsule{{-1, 0.4f, 0}, {1, 0.5f, 0}, 0.2f}, 0.2f},
         {Capsule{{-1, 0.42f, 0}, {1, 0.5f, 0.02f}, 0.2f}, 0.2f}},
        {{Plane{{0, 1, 0.1f}, -0.2f}, 0.9f}, {Plane{{0, 2, 0.21f}, -0.19f}, 0.9f}},
        at_rest({Sphere{{0.3f, 0.2f, 0}, 0.4f}, 0.6f})};
    const Particles particles = cloud(block_size);
    const float thickness = 0.02f, reach = 0.1f, gamma = 0.02f;
    std::size_t contested = 0;
    for (int order = 0; order < 4; ++order) {
        std::ranges::rotate(all, all.begin() + 1);
        NearSurfaces near;
        ASSERT_TRUE(find_near_surfaces(all, thickness, 0.5f, h, reach, particles.positions, gamma,
                                       particles.velocities, near));
        for (std::size_t i = 0; i < block_size; ++i) {
            const Vector3 p = xyz(particles.positions[i]) + gamma * xyz(particles.velocities[i]);
            ReferenceSurface nearest{reach + thickness, Vector3::Zero(), Vector3::Zero()};
            float friction = 0;
            int within = 0;
            for (const ColliderMotion& motion : all) {
                const ReferenceSurface surface = std::visit(
                    [&]<class Shape>(const Shape& end) {
                        return reference_surface(std::get<Shape>(motion.start.shape), end, h, p);
                    },
                    motion.end.shape);
                within += surface.distance < reach + thickness ? 1 : 0;
                if (!(surface.distance < nearest.distance)) continue;
                nearest = surface;
                friction = 0.5f * motion.end.friction;
            }
            contested += within > 1 ? 1 : 0;
            EXPECT_NEAR(near.surfaces.w[i], nearest.distance - thickness, 1e-5f) << i;
            const Vector3 normal(near.surfaces.x[i], near.surfaces.y[i], near.surfaces.z[i]),
                motion(near.motions.x[i], near.motions.y[i], near.motions.z[i]);
            EXPECT_LT((normal - nearest.normal).norm(), 1e-3f) << i;
            EXPECT_LT((motion - nearest.velocity).norm(), 1e-2f) << i;
            EXPECT_FLOAT_EQ(near.motions.w[i], friction) << i;
        }
    }
    EXPECT_GT(contested, 100u);
}

TEST(Colliders, BlendGoesFromOneToTheOther) {
    const Collider sphere = blend({Sphere{{0, 0, 0}, 1}, 0.2f}, {Sphere{{4, 8, 0}, 3}, 0.6f}, 0.25f);
    EXPECT_FLOAT_EQ(std::get<Sphere>(sphere.shape).center.y, 2);
    EXPECT_FLOAT_EQ(std::get<Sphere>(sphere.shape).radius, 1.5f);
    EXPECT_FLOAT_EQ(sphere.friction, 0.3f);

    const Collider capsule =
        blend({Capsule{{0, 0, 0}, {1, 0, 0}, 1}, 0}, {Capsule{{0, 2, 0}, {3, 0, 0}, 2}, 0}, 0.5f);
    EXPECT_FLOAT_EQ(std::get<Capsule>(capsule.shape).a.y, 1);
    EXPECT_FLOAT_EQ(std::get<Capsule>(capsule.shape).b.x, 2);
    EXPECT_FLOAT_EQ(std::get<Capsule>(capsule.shape).radius, 1.5f);

    const Collider plane = blend({Plane{{0, 5, 0}, 1}, 0}, {Plane{{0.5f, 0, 0}, 3}, 0}, 0.5f);
    EXPECT_NEAR(std::get<Plane>(plane.shape).normal.x, std::sqrt(0.5f), 1e-6f);
    EXPECT_NEAR(std::get<Plane>(plane.shape).normal.y, std::sqrt(0.5f), 1e-6f);
    EXPECT_FLOAT_EQ(std::get<Plane>(plane.shape).offset, 2);

    const Collider turned = blend({Plane{{0, 1, 0}, 0}, 0}, {Plane{{0, -1, 0}, 0}, 0}, 0.5f);
    EXPECT_TRUE(validate(turned).ok());
}

}  // namespace
}  // namespace weft::test
