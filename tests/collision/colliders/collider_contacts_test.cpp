// How colliders push particles, and rub.

#include "collision/thin/collide.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/collision/colliders/collider_reference.h"
#include "tests/collision/particle_cloud.h"

namespace weft::test {
namespace {

constexpr float gravity = 9.81f;

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

TEST(Colliders, TaperedCapsuleKeepsParticlesAtItsSignedDistance) {
    // Wider at either end, with one end's ball in the other's, and a cone all but flat.
    for (const TaperedCapsule& shape : {TaperedCapsule{{-0.6f, 0.1f, 0}, {0.3f, -0.2f, 0.5f}, 0.3f, 0.1f},
                                        TaperedCapsule{{-0.6f, 0.1f, 0}, {0.3f, -0.2f, 0.5f}, 0.05f, 0.4f},
                                        TaperedCapsule{{0, 0.1f, 0}, {0, 0.3f, 0}, 0.6f, 0.1f},
                                        TaperedCapsule{{0, 0.1f, 0}, {0, 0.3f, 0}, 0.1f, 0.6f},
                                        TaperedCapsule{{0, 0.1f, 0}, {0, 0.3f, 0}, 0.1f, 0.295f}})
        expect_pushed_to_surface({shape, 0.4f}, [&](const Vec4& p) {
            float nearest = inf;
            for (int k = 0; k <= 4000; ++k) {
                const float t = static_cast<float>(k) / 4000.0f;
                const Vector3 center = to_vector(shape.a) + t * (to_vector(shape.b) - to_vector(shape.a));
                nearest = std::min(nearest, (xyz(p) - center).norm() - shape.radius_a -
                                                t * (shape.radius_b - shape.radius_a));
            }
            return nearest;
        });
}

TEST(Colliders, BoxKeepsParticlesAtItsSignedDistance) {
    const Box box{{0.1f, 0.05f, -0.1f}, {0.2f, -0.4f, 0.4f, 0.8f}, {0.5f, 0.2f, 0.35f}};
    expect_pushed_to_surface({box, 0.4f},
                             [&](const Vec4& p) { return reference_surface(box, box, h, xyz(p)).distance; });
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
    particles = {{{1, 1, 1, 1}}, {{}}};
    meet(particles, {at_rest({Box{{1, 1, 1}, {}, {0.5f, 0.4f, 0.5f}}, 0.4f})}, 0.1f);
    EXPECT_NEAR(particles.positions[0].y, 1.5f, 1e-6f);
    particles = {{{1, 0, 0, 1}}, {{}}};
    meet(particles, {at_rest(capsule)}, 0.1f);
    EXPECT_EQ(particles.positions[0].x, 1);
    EXPECT_NEAR(std::hypot(particles.positions[0].y, particles.positions[0].z), 0.6f, 1e-6f);
}

TEST(Colliders, ParticlesThatAreNotFiniteAreLeft) {
    Particles particles{{{nan, 0, 0, 1}, {inf, 0, 0, 1}}, {{}, {}}};
    const std::vector<ColliderMotion> all{at_rest({Sphere{{0, 0, 0}, 1}, 0.4f}),
                                          at_rest({Capsule{{0, 0, 0}, {1, 0, 0}, 1}, 0.4f}),
                                          at_rest({TaperedCapsule{{}, {1, 0, 0}, 1, 0.5f}, 0.4f}),
                                          at_rest({Box{{}, {}, {1, 1, 1}}, 0.4f}),
                                          at_rest({Box{{}, {0.6f, 0, 0, 0.8f}, {1, 1, 1}}, 0.4f}),
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

TEST(Colliders, ATurningBoxAndOneThatGrowsPushAtTheirSurfacesSpeed) {
    // 1 rad/s about z: 0.8 m out on the top the surface rises at 0.8 m/s, and comes back at 0.1 m/s.
    const float turn = 0.5f * h;
    const Box still{{}, {}, {1, 0.1f, 1}}, turned{{}, {0, 0, std::sin(turn), std::cos(turn)}, {1, 0.1f, 1}};
    Particles particles{{{0.8f, 0.1f, 0, 1}}, {{}}};
    meet(particles, {{{still, 0}, {turned, 0}}}, 0);
    EXPECT_NEAR(particles.velocities[0].y, 0.8f, 0.01f);
    particles = {{{0.8f, 0.1f, 0, 1}}, {{}}};
    meet(particles, {{{still, 1e3f}, {turned, 1e3f}}}, 0);  // it takes all along
    EXPECT_NEAR(particles.velocities[0].x, -0.1f, 0.01f);

    particles = {{{0.8f, 0.1f, 0, 1}}, {{}}};
    meet(particles, {{{still, 0}, {Box{{}, {}, {1, 0.1f + 2 * h, 1}}, 0}}}, 0);
    EXPECT_NEAR(particles.velocities[0].y, 2, 1e-3f);
    EXPECT_NEAR(particles.positions[0].y, 0.1f + 2 * h, 1e-6f);
}

TEST(Colliders, ATaperedCapsuleThatGrowsAtOneEndPushesThere) {
    const auto shape = [](float radius_b) {
        return Collider{TaperedCapsule{{-1, 0, 0}, {1, 0, 0}, 0.2f, radius_b}, 0};
    };
    Particles particles{{{1, 0.2f, 0, 1}, {-1, 0.2f, 0, 1}}, {{}, {}}};
    meet(particles, {{shape(0.2f), shape(0.2f + 3 * h)}}, 0);
    EXPECT_NEAR(particles.velocities[0].y, 3, 0.01f);
    EXPECT_NEAR(particles.velocities[1].y, 0, 0.05f);
}

TEST(Colliders, ManyAtATimeDoAsOneByOne) {
    const std::vector<ColliderMotion> all{
        {{TaperedCapsule{{-0.8f, -0.4f, 0}, {0.6f, -0.5f, 0.1f}, 0.3f, 0.1f}, 0.3f},
         {TaperedCapsule{{-0.8f, -0.42f, 0}, {0.61f, -0.5f, 0.1f}, 0.31f, 0.1f}, 0.3f}},
        {{Box{{0.5f, 0.6f, -0.4f}, {0.1f, 0.2f, 0.3f, 0.927362f}, {0.3f, 0.2f, 0.4f}}, 0.3f},
         {Box{{0.51f, 0.6f, -0.41f}, {0.11f, 0.2f, 0.3f, 0.926220f}, {0.3f, 0.2f, 0.4f}}, 0.3f}},
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

TEST(Colliders, OfSeveralTheNearestSurfaceIsFoundWhateverTheirOrder) {
    std::vector<ColliderMotion> all{
        {{Sphere{{0, 0, 0}, 0.5f}, 0.4f}, {Sphere{{0.01f, 0, 0.02f}, 0.51f}, 0.4f}},
        {{Capsule{{-1, 0.4f, 0}, {1, 0.5f, 0}, 0.2f}, 0.2f},
         {Capsule{{-1, 0.42f, 0}, {1, 0.5f, 0.02f}, 0.2f}, 0.2f}},
        {{Plane{{0, 1, 0.1f}, -0.2f}, 0.9f}, {Plane{{0, 2, 0.21f}, -0.19f}, 0.9f}},
        {{TaperedCapsule{{-0.8f, 0.4f, 0.5f}, {0.6f, 0.5f, 0.4f}, 0.2f, 0.1f}, 0.3f},
         {TaperedCapsule{{-0.8f, 0.42f, 0.5f}, {0.61f, 0.5f, 0.4f}, 0.21f, 0.1f}, 0.3f}},
        {{Box{{0.5f, 0.6f, -0.4f}, {0.1f, 0.2f, 0.3f, 0.927362f}, {0.3f, 0.2f, 0.4f}}, 0.7f},
         {Box{{0.51f, 0.6f, -0.41f}, {0.11f, 0.2f, 0.3f, 0.926220f}, {0.3f, 0.2f, 0.4f}}, 0.7f}},
        at_rest({Sphere{{0.3f, 0.2f, 0}, 0.4f}, 0.6f})};
    const Particles particles = cloud(block_size);
    const float thickness = 0.02f, reach = 0.1f, gamma = 0.02f;
    std::size_t contested = 0;
    for (int order = 0; order < 6; ++order) {
        std::ranges::rotate(all, all.begin() + 1);
        NearSurfaces near;
        ASSERT_TRUE(find_near_surfaces(all, EvenSide(block_size, thickness, 0.5f), h, reach, {},
                                       particles.positions, gamma, particles.velocities, near));
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

// Found 2 mm below the ground, 4.5 mm under a ceiling: that is nearer than the cloth's thickness, and farther
// than the particle's own.
TEST(ColliderContacts, WhatComesOutOfOneKeepsItsOwnThicknessToAnother) {
    const std::vector<ColliderMotion> motions{at_rest({Plane{{0, 1, 0}, 0}}),
                                              at_rest({Plane{{0, -1, 0}, -0.0025f}})};
    const EvenSide thin(1, 0.001f, 1);
    for (const float most : {0.001f, 0.005f}) {
        ClothSide side = thin;
        side.most_thickness = most;
        Particles particles{{{0, -0.002f, 0, 1}}, {{}}};
        const std::vector<Vec4> starts = particles.positions;
        Parallel serial(1);
        std::vector<std::uint32_t> partials(1);
        collide(serial, motions, side, h,
                {.positions = particles.positions, .velocities = particles.velocities, .starts = starts},
                partials);
        EXPECT_NEAR(particles.positions[0].y, -0.002f + 0.1f * h, 1e-6f) << most;
    }
}

}  // namespace
}  // namespace weft::test
