// What hands do to things: throw balls, move colliders, stir the air.

#include <gtest/gtest.h>

#include <cmath>

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

TEST(Balls, ThatNobodyThrewStayOutOfSight) {
    World world = World::create(SmallWorld::one_thread()).value();
    Balls balls;
    ASSERT_TRUE(balls.set_there(world, true));
    for (int k = 0; k < 2000; ++k) {
        balls.before_step(world, tick);
        world.step(tick);
    }
    EXPECT_TRUE(balls.in_play(world).empty());
    EXPECT_GT(place_of(world, balls, 2).y, -700);
    ASSERT_TRUE(balls.set_there(world, false));
    EXPECT_EQ(balls.bodies().size(), 0u);
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

TEST(HandAir, ATaperedLimbLeavesAWake) {
    World world = World::create(SmallWorld::one_thread()).value();
    const auto limb = [](float x) {
        return Collider{.shape = TaperedCapsule{{x, 1, 0}, {x, 2, 0}, 0.3f, 0.1f}};
    };
    const ColliderId moving[] = {*world.add_collider(limb(0))};
    HandAir air;
    air.before_step(world, moving, {}, tick);
    ASSERT_TRUE(world.move_collider(moving[0], limb(2 * tick)));
    world.step(tick);
    air.before_step(world, moving, {}, tick);
    const AirSource& wake = world.settings().wind.sources[0];
    EXPECT_EQ(wake.kind, AirSourceKind::wake);
    EXPECT_NEAR(wake.velocity.x, 2, 1e-3f);
    EXPECT_NEAR(wake.position.y, 1.5f, 1e-5f);
    EXPECT_NEAR(wake.radius, 0.2f, 1e-5f);
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

TEST(Streaks, DriftWithTheAirWithinTheirBox) {
    WorldSettings settings = SmallWorld::one_thread();
    settings.wind.velocity = {3, 0, -1};
    World world = World::create(settings).value();
    Streaks streaks;
    EXPECT_FALSE(streaks.visible) << "nobody has asked for them";
    streaks.visible = true;
    streaks.begin({0, 1, 0}, 1.5f);
    ASSERT_EQ(streaks.motes().size(), Streaks::count);
    int drifted = 0;
    for (int k = 0; k < 60; ++k) {
        streaks.step(world, tick, {0, 1, 4});
        for (const Streaks::Mote& mote : streaks.motes()) {
            EXPECT_LE(std::abs(mote.trail[0].x), 1.5f);
            if (mote.kept < 2) continue;
            ++drifted;
            EXPECT_NEAR(mote.trail[0].x - mote.trail[1].x, 3 * tick, 1e-5f);
            EXPECT_NEAR(mote.trail[0].z - mote.trail[1].z, -tick, 1e-5f);
        }
    }
    EXPECT_GT(drifted, 1000);
    const std::vector<render::DrawnLine> lines = streaks.lines();
    EXPECT_GT(lines.size(), 200u);
    for (const render::DrawnLine& each : lines) {
        EXPECT_GE(each.opacity, 0);
        EXPECT_LT(each.opacity, 1);
    }
    EXPECT_GT(lines[0].opacity, lines[2].opacity) << "what is older is fainter";
    streaks.visible = false;
    EXPECT_TRUE(streaks.lines().empty());
}

TEST(Project, IsWhereTheRayThroughItLeads) {
    const render::OrbitCamera camera{
        .target = {0.3f, 1, -0.2f}, .distance = 2.5f, .yaw = 0.8f, .pitch = 0.3f};
    for (const Vec2 place : {Vec2{0.2f, 0.3f}, Vec2{0.9f, 0.7f}, Vec2{0.5f, 0.5f}}) {
        const render::Ray ray = camera.ray(place.x, place.y, 1.6f);
        const auto back =
            project(camera, to_vec3(to_vector(ray.origin) + 1.7f * to_vector(ray.direction)), 1.6f);
        ASSERT_TRUE(back);
        EXPECT_NEAR(back->x, 1.6f * place.x, 1e-4f);
        EXPECT_NEAR(back->y, place.y, 1e-4f);
    }
    EXPECT_FALSE(project(camera, to_vec3(2 * to_vector(camera.eye()) - to_vector(camera.target)), 1.6f));
}

TEST(Streaks, DoNotLieOverTheCloth) {
    SmallWorld small;  // a sheet at z = 0
    WorldSettings settings = small.world.settings();
    settings.gravity = {};
    settings.wind.velocity = {0.2f, 0, 0};
    ASSERT_TRUE(small.world.set_settings(settings).ok());
    Streaks streaks;
    streaks.visible = true;
    streaks.begin({0.5f, 0.5f, 0}, 0.5f);
    const Vec3 eye{0.5f, 0.5f, 6};
    for (int k = 0; k < 20; ++k) streaks.step(small.world, tick, eye);
    int before = 0, behind = 0, over_cloth = 0;
    for (const Streaks::Mote& mote : streaks.motes()) {
        const Vec3& at = mote.trail[0];
        if (std::abs(at.x - 0.5f) > 0.4f || std::abs(at.y - 0.5f) > 0.4f || std::abs(at.z) < 0.05f) continue;
        ++(at.z > 0 ? before : behind);
        if (at.z > 0 && !mote.before_cloth) ++over_cloth;
        EXPECT_FALSE(at.z < 0 && mote.before_cloth) << "cloth hides it by itself";
    }
    EXPECT_GT(std::min(before, behind), 10);
    EXPECT_LT(over_cloth, before / 4) << "but for those that are new";
}

}  // namespace
}  // namespace weft::demo
