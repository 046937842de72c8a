// Bodies on the World's colliders: rest, slopes, edges, fast balls, moved platforms.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "engine/vector.h"
#include "weft/weft.h"

namespace weft::test::body_contacts {
namespace {

constexpr float h = 1.0f / 60, g = 9.81f;

Rotation turned(const Vector3& axis, float angle) {
    const Eigen::Quaternionf q(Eigen::AngleAxisf(angle, axis.normalized()));
    return {q.x(), q.y(), q.z(), q.w()};
}

/// A World without air.
struct FreeBodies {
    FreeBodies() : world(make_world()) {}
    static World make_world() {
        WorldSettings settings;
        settings.threads = 1;
        settings.wind.air_density = 0;
        return World::create(settings).value();
    }

    /// A body of 1 kg, of which the collider is given in the World.
    BodyId add(const Collider& collider, const BodyState& state, float inertia = 5e-3f) {
        const BodyId body =
            world.add_body({.mass = 1, .inertia = {inertia, inertia, inertia}}, state).value();
        EXPECT_TRUE(world.attach_collider(body, world.add_collider(collider).value()));
        return body;
    }
    BodyId add_ball(float radius, const BodyState& state) {
        return add({.shape = Sphere{state.position, radius}}, state, 0.4f * radius * radius);
    }
    BodyId add_box(const Vec3& half, const BodyState& state, float friction = 0.4f) {
        return add({.shape = Box{state.position, state.rotation, half}, .friction = friction}, state);
    }
    void steps(int count) {
        for (int k = 0; k < count; ++k) world.step(h);
    }
    [[nodiscard]] Vector3 place(BodyId body) const { return to_vector(world.body_state(body)->position); }
    [[nodiscard]] Vector3 velocity(BodyId body) const { return to_vector(world.body_state(body)->velocity); }
    /// The speed of the body and of what is .1 m from its centre [m/s].
    [[nodiscard]] float speed(BodyId body) const {
        return velocity(body).norm() + 0.1f * to_vector(world.body_state(body)->angular_velocity).norm();
    }

    World world;
};

/// Hills whose heights are between -.02 and .02 m.
TriangleMesh hills() {
    constexpr std::uint32_t side = 21;
    static std::vector<Vec3> vertices;
    static std::vector<std::array<std::uint32_t, 3>> triangles;
    vertices.clear();
    triangles.clear();
    for (std::uint32_t r = 0; r < side; ++r)
        for (std::uint32_t c = 0; c < side; ++c) {
            const auto x = static_cast<float>(c) - 10, z = static_cast<float>(r) - 10;
            vertices.push_back({0.1f * x, 0.02f * std::sin(z) * std::cos(0.7f * x), 0.1f * z});
            if (r + 1 == side || c + 1 == side) continue;
            const std::uint32_t a = r * side + c;
            triangles.push_back({a, a + side, a + 1});
            triangles.push_back({a + 1, a + side, a + side + 1});
        }
    return {.vertices = vertices, .triangles = triangles, .closed = false};
}

std::vector<Vec3> points_on_ball(float radius) {
    std::vector<Vec3> points;
    for (int k = 0; k < 40; ++k) {
        const float y = -1 + 2 * (static_cast<float>(k) + 0.5f) / 40, r = std::sqrt(1 - y * y),
                    a = 2.4f * static_cast<float>(k);
        points.push_back({radius * r * std::cos(a), radius * y, radius * r * std::sin(a)});
    }
    return points;
}

TEST(BodyContacts, WhatFallsOnThePlaneComesToRestOnIt) {
    FreeBodies scene;
    ASSERT_TRUE(scene.world.add_collider({.shape = Plane{}}));
    const BodyId ball = scene.add_ball(0.1f, {.position = {-1, 0.5f, 0}});
    const Rotation tilted = turned({1, 0, 0.3f}, 0.6f);
    const BodyId box = scene.add_box({0.1f, 0.05f, 0.15f}, {.position = {0, 0.5f, 0}, .rotation = tilted});
    const Vec3 rod{1, 0.5f, 0};
    const BodyId capsule = scene.add({.shape = Capsule{{0.9f, 0.45f, 0}, {1.1f, 0.55f, 0}, 0.04f}},
                                     {.position = rod, .rotation = {}});
    scene.steps(240);
    EXPECT_NEAR(scene.place(ball).y(), 0.1f, 1e-4f);
    EXPECT_NEAR(scene.place(box).y(), 0.05f, 1e-3f);
    EXPECT_NEAR(scene.place(capsule).y(), 0.04f, 1e-3f);
    for (const BodyId body : {ball, box, capsule}) EXPECT_LT(scene.speed(body), 2e-3f);
}

TEST(BodyContacts, ABeamLiesOnTwoRails) {
    for (const bool round : {false, true}) {
        FreeBodies scene;
        for (const float x : {-0.3f, 0.3f}) {
            Collider rail{.shape = Box{.center = {x, 0, 0}, .half_extents = {0.05f, 0.05f, 0.5f}}};
            if (round) rail.shape = Capsule{{x, 0, -0.5f}, {x, 0, 0.5f}, 0.05f};
            ASSERT_TRUE(scene.world.add_collider(rail));
        }
        const BodyId beam = scene.add_box({0.5f, 0.02f, 0.03f}, {.position = {0, 0.2f, 0}});
        scene.steps(180);
        EXPECT_NEAR(scene.place(beam).y(), 0.07f, 1e-3f) << round;
        EXPECT_LT(scene.speed(beam), 2e-3f) << round;
    }
}

TEST(BodyContacts, ABoxOnASlopeFollowsCoulombsLaw) {
    constexpr float slope = 0.35f;
    for (const float friction : {0.0f, 0.2f, 0.5f}) {
        FreeBodies scene;
        ASSERT_TRUE(scene.world.add_collider(
            {.shape = Plane{.normal = {std::sin(slope), std::cos(slope), 0}}, .friction = friction}));
        const Vector3 start = 0.1f * Vector3(std::sin(slope), std::cos(slope), 0);
        const BodyId box = scene.add_box(
            {0.1f, 0.1f, 0.1f}, {.position = to_vec3(start), .rotation = turned(Vector3::UnitZ(), -slope)},
            friction);
        scene.steps(60);
        const float wanted = std::max(0.0f, 0.5f * g * (std::sin(slope) - friction * std::cos(slope)));
        EXPECT_NEAR((scene.place(box) - start).norm(), wanted, 0.03f * wanted + 1e-3f) << friction;
    }
}

TEST(BodyContacts, AFastBallPassesNothingThin) {
    for (const bool of_triangles : {false, true})
        for (const float speed : {3.0f, 20.0f, 90.0f}) {
            FreeBodies scene;
            Collider floor{.shape = Box{.half_extents = {1, 5e-3f, 1}}};
            if (of_triangles) floor.shape = PlacedShape{scene.world.add_shape(hills()).value()};
            ASSERT_TRUE(scene.world.add_collider(floor));
            const BodyId ball =
                scene.add_ball(0.02f, {.position = {0.03f, 0.5f, 0.02f}, .velocity = {0, -speed, 0}});
            for (int k = 0; k < 60; ++k) {
                scene.world.step(h);
                if (std::abs(scene.place(ball).z()) > 0.9f) break;  // it rolls off
                ASSERT_GT(scene.place(ball).y(), -0.02f) << of_triangles << ' ' << speed;
            }
        }
}

TEST(BodyContacts, BoxesAndHullsRestOnATriangleMesh) {
    FreeBodies scene;
    ASSERT_TRUE(scene.world.add_collider({.shape = PlacedShape{scene.world.add_shape(hills()).value()}}));
    const BodyId box = scene.add_box({0.1f, 0.1f, 0.1f}, {.position = {0, 0.4f, 0}});
    const std::vector<Vec3> points = points_on_ball(0.1f);
    const ShapeId hull = scene.world.add_shape(ConvexHull{.points = points}).value();
    const Vec3 above{0.5f, 0.4f, 0};
    const BodyId stone = scene.add({.shape = PlacedShape{hull, above}}, {.position = above});
    scene.steps(400);
    for (const BodyId body : {box, stone}) {
        EXPECT_GT(scene.place(body).y(), 0.06f);
        EXPECT_LT(scene.place(body).y(), 0.13f);
        EXPECT_LT(scene.speed(body), 0.02f);
    }
}

TEST(BodyContacts, ABallBouncesByTheGreaterRestitution) {
    FreeBodies scene;
    ASSERT_TRUE(scene.world.add_collider({.shape = Plane{}, .restitution = 0.5f}));
    const BodyId ball = scene.add_ball(0.1f, {.position = {0, 1.1f, 0}});
    float top = 0;
    bool has_met = false;
    for (int k = 0; k < 70; ++k) {
        scene.world.step(h);
        has_met = has_met || scene.velocity(ball).y() > 0;
        if (has_met) top = std::max(top, scene.place(ball).y() - 0.1f);
    }
    EXPECT_NEAR(top, 0.25f, 0.02f);
}

TEST(BodyContacts, APlatformTakesABoxAlong) {
    FreeBodies scene;
    const auto platform = [](float t) -> Collider {
        return {.shape = Box{.center = {0.5f * t, 0.3f * t, 0}, .half_extents = {1, 0.1f, 1}}};
    };
    const ColliderId moved = scene.world.add_collider(platform(0)).value();
    const BodyId box = scene.add_box({0.1f, 0.1f, 0.1f}, {.position = {0, 0.2f, 0}});
    for (int k = 1; k <= 120; ++k) {
        ASSERT_TRUE(scene.world.move_collider(moved, platform(static_cast<float>(k) * h)));
        scene.world.step(h);
    }
    EXPECT_NEAR(scene.place(box).x(), 1, 0.05f);  // it slides until friction has given it the speed
    EXPECT_NEAR(scene.place(box).y(), 0.8f, 2e-3f);
    EXPECT_LT((scene.velocity(box) - Vector3(0.5f, 0.3f, 0)).norm(), 0.01f);
}

TEST(BodyContacts, LayersThatShareNothingDoNotMeet) {
    FreeBodies scene;
    ASSERT_TRUE(scene.world.add_collider({.shape = Plane{}, .layers = 2}));
    ASSERT_TRUE(scene.world.add_collider({.shape = Plane{.offset = -0.3f}, .is_trigger = true}));
    const BodyId ball = scene.add_ball(0.1f, {.position = {0, 0.2f, 0}});
    scene.steps(60);
    EXPECT_NEAR(scene.place(ball).y(), 0.2f - 0.5f * g, 0.1f);
}

TEST(BodyContacts, WhatIsFoundInsideComesOutSlowly) {
    FreeBodies scene;
    ASSERT_TRUE(scene.world.add_collider({.shape = Plane{}}));
    const BodyId box = scene.add_box({0.1f, 0.1f, 0.1f}, {.position = {0, 0.02f, 0}});
    for (int k = 0; k < 120; ++k) {
        scene.world.step(h);
        ASSERT_LT(scene.speed(box), 0.11f);
    }
    EXPECT_NEAR(scene.place(box).y(), 0.1f, 1e-3f);
}

}  // namespace
}  // namespace weft::test::body_contacts
