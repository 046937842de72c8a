// What hands do to things: throw balls, move colliders, stir the air.

#include <gtest/gtest.h>

#include "demo/hands/air/hand_air.h"
#include "demo/hands/air/streaks.h"
#include "demo/hands/balls.h"
#include "demo/hands/hands.h"
#include "demo/hands/project.h"
#include "engine/vector.h"
#include "tests/demo/small_world.h"

namespace weft::demo {
namespace {

constexpr float tick = 1.0f / 60;

Vec3 place_of(const World& world, const Balls& balls, std::size_t which) {
    return world.body_state(balls.bodies()[which])->position;
}

TEST(Balls, FlyAsTheyAreThrownAndBounceOnTheFloor) {
    World world = World::create(SmallWorld::one_thread()).value();
    Balls balls;
    ASSERT_TRUE(balls.throw_along(world, {{0, 1, 0}, {1, 0, 0}}));
    EXPECT_EQ(balls.in_play(world).size(), 1u);
    float lowest = 1, highest_after = 0;
    bool bounced = false;
    for (int k = 0; k < 90; ++k) {
        balls.before_step(world, tick);
        world.step(tick);
        const Vec3 place = place_of(world, balls, 0);
        lowest = std::min(lowest, place.y);
        if (k == 14) {  // a quarter of a second: before the floor
            EXPECT_NEAR(place.x, 0.22f + 9 * 0.25f, 0.05f);
            EXPECT_NEAR(place.y, 1 - 0.5f * 9.81f * 0.0625f, 0.05f);
        }
        if (world.body_state(balls.bodies()[0])->velocity.y > 1) bounced = true;
        if (bounced) highest_after = std::max(highest_after, place.y);
    }
    EXPECT_TRUE(bounced);
    EXPECT_GT(lowest, 0.5f * Balls::radius);
    EXPECT_NEAR(highest_after, Balls::radius + 0.89f * Balls::bounce * Balls::bounce, 0.08f);
}

TEST(Balls, TheOldestIsThrownAgain) {
    World world = World::create(SmallWorld::one_thread()).value();
    Balls balls;
    for (std::size_t k = 0; k < Balls::count + 1; ++k)
        ASSERT_TRUE(balls.throw_along(world, {{0, 1 + 0.1f * static_cast<float>(k), 0}, {0, 0, 1}}));
    EXPECT_EQ(balls.in_play(world).size(), Balls::count);
    EXPECT_NEAR(place_of(world, balls, 0).y, 1 + 0.1f * Balls::count, 1e-5f);
    EXPECT_NEAR(place_of(world, balls, 1).y, 1.1f, 1e-5f);
}

TEST(Balls, PushCloth) {
    SmallWorld small;
    Balls balls;
    ASSERT_TRUE(balls.throw_along(small.world, {{0.5f, 0.6f, 1.2f}, {0, 0, -1}}));
    float farthest = 0;
    for (int k = 0; k < 20; ++k) {
        balls.before_step(small.world, tick);
        small.world.step(tick);
        for (const Vec4& p : small.world.cloth(small.cloths.front().id)->positions)
            farthest = std::min(farthest, p.z);
    }
    EXPECT_LT(farthest, -0.1f);
}

TEST(HeldCollider, TheNearestThatTheRayMeetsComesAlongAndGrows) {
    World world = World::create(SmallWorld::one_thread()).value();
    const ColliderId near = *world.add_collider({.shape = Sphere{{0, 1, 0}, 0.2f}});
    const ColliderId far = *world.add_collider({.shape = Box{.center = {0, 1, -2}}});
    const ColliderId all[] = {far, near};
    const render::Ray ray{{0, 1, 3}, {0, 0, -1}};
    EXPECT_NEAR(*distance_to(*world.collider(near), ray), 2.8f, 2e-3f);
    EXPECT_FALSE(distance_to(*world.collider(near), {{0, 1.3f, 3}, {0, 0, -1}}));
    HeldCollider held;
    EXPECT_FALSE(held.begin(world, all, ray, {0, 0, -1}, 2.5f)) << "cloth is before it";
    ASSERT_TRUE(held.begin(world, all, ray, {0, 0, -1}, 100));
    EXPECT_EQ(held.id(), near);
    held.aim({{0.3f, 1.1f, 3}, {0, 0, -1}});
    held.scale(1.5f);
    for (int k = 0; k < 60; ++k) {
        const Vec3 before = std::get<Sphere>(world.collider(near)->shape).center;
        held.before_step(world, tick);
        world.step(tick);
        const Vec3 after = std::get<Sphere>(world.collider(near)->shape).center;
        EXPECT_LE((to_vector(after) - to_vector(before)).norm(), 1.001f * HeldCollider::max_speed * tick);
    }
    const Sphere sphere = std::get<Sphere>(world.collider(near)->shape);
    EXPECT_NEAR(sphere.center.x, 0.3f, 1e-4f);
    EXPECT_NEAR(sphere.center.y, 1.1f, 1e-4f);
    EXPECT_NEAR(sphere.radius, 0.3f, 1e-4f);
}

TEST(HandAir, FanBlastAndWakesAreInTheWindAndGoAgain) {
    World world = World::create(SmallWorld::one_thread()).value();
    const auto kinds = [&](AirSourceKind kind) {
        return std::ranges::count(world.settings().wind.sources, kind, &AirSource::kind);
    };
    const ColliderId ball = *world.add_collider({.shape = Sphere{{0, 1, 0}, 0.2f}});
    const ColliderId moving[] = {ball};
    HandAir air;
    air.hold_fan({{1, 2, 3}, {0, 0, -1}});
    air.blast_at({4, 5, 6});
    for (int k = 0; k < 3; ++k) {
        ASSERT_TRUE(
            world.move_collider(ball, {.shape = Sphere{{0.05f * static_cast<float>(k), 1, 0}, 0.2f}}));
        air.before_step(world, moving, {}, tick);
        world.step(tick);
    }
    EXPECT_EQ(kinds(AirSourceKind::jet), 1);
    EXPECT_EQ(kinds(AirSourceKind::blast), 1);
    ASSERT_EQ(kinds(AirSourceKind::wake), 1);
    const auto& sources = world.settings().wind.sources;
    const AirSource wake = *std::ranges::find(sources, AirSourceKind::wake, &AirSource::kind);
    EXPECT_NEAR(wake.velocity.x, 3, 1e-3f);
    EXPECT_EQ(wake.radius, 0.2f);
    EXPECT_NEAR(sources[0].velocity.z, -air.fan_speed, 1e-5f);
    air.put_fan_away();
    for (int k = 0; k < 60; ++k) {
        air.before_step(world, moving, {}, tick);
        world.step(tick);
    }
    EXPECT_EQ(kinds(AirSourceKind::none), static_cast<std::ptrdiff_t>(sources.size()));
}

TEST(HandAir, WhatIsForgottenBlowsNoMore) {
    World world = World::create(SmallWorld::one_thread()).value();
    HandAir air;
    air.hold_fan({{1, 2, 3}, {0, 0, -1}});
    air.before_step(world, {}, {}, tick);
    ASSERT_EQ(world.settings().wind.sources[0].kind, AirSourceKind::jet);
    air.forget();
    air.before_step(world, {}, {}, tick);
    EXPECT_EQ(world.settings().wind.sources[0].kind, AirSourceKind::none);
}

}  // namespace
}  // namespace weft::demo
