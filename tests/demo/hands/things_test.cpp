// Hands throw balls, move colliders and stir the air.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "demo/hands/air/hand_air.h"
#include "demo/hands/air/wind_arrow.h"
#include "demo/hands/hands.h"
#include "demo/hands/held_collider.h"
#include "demo/hands/project.h"
#include "demo/time/time_bar.h"
#include "demo/time/timeline.h"
#include "demo/window/wind_control.h"
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

// The wind's arrow and the gamepad.

constexpr float pi = std::numbers::pi_v<float>;

float apart(float a, float b) {
    return std::abs(std::remainder(a - b, 2 * pi));
}

/// The wind's velocity in the camera's directions: to the right, and away.
Vec2 as_seen(const WindControl& wind, float yaw) {
    const Vec3 v = wind.velocity();
    return {v.x * std::cos(yaw) - v.z * std::sin(yaw), -v.x * std::sin(yaw) - v.z * std::cos(yaw)};
}

TEST(WindArrow, TheTipIsWhereItWasDraggedTo) {
    for (const float yaw : {0.0f, 0.7f, -2.5f})
        for (const float pitch : {-0.3f, 0.05f, 1.2f}) {
            WindArrow arrow;
            arrow.place({.yaw = yaw, .pitch = pitch}, 1.6f);
            WindControl wind;
            for (const Vec2 way : {Vec2{0.2f, 0.03f}, Vec2{-0.1f, 0.1f}, Vec2{0.02f, -0.15f}}) {
                const Vec2 place = arrow.at(way.x, way.y);
                arrow.drag(place, wind);
                EXPECT_NEAR(arrow.tip(wind).x, place.x, 1e-4f);
                EXPECT_NEAR(arrow.tip(wind).y, place.y, 1e-4f);
                EXPECT_TRUE(arrow.is_under(place, wind));
                const Vec2 seen = as_seen(wind, yaw);
                EXPECT_NEAR(std::atan2(seen.y, seen.x), std::atan2(way.y, way.x), 1e-3f)
                    << "the wind blows as the arrow points";
            }
        }
}

TEST(WindArrow, LongerIsFasterAndItsFootIsStill) {
    WindArrow arrow;
    arrow.place({}, 1.5f);
    WindControl wind({3, 0, 0});
    arrow.drag(arrow.foot(), wind);
    EXPECT_EQ(wind.speed(), 0);
    EXPECT_NEAR(wind.heading(), 0, 1e-6f) << "still air keeps its heading";
    float last = -1;
    for (const float length : {0.05f, 0.1f, 0.2f, 0.25f, 0.3f, 0.8f}) {
        arrow.drag(arrow.at(length, 0), wind);
        EXPECT_GE(wind.speed(), last);
        last = wind.speed();
    }
    EXPECT_EQ(last, WindControl::max_speed);
}

TEST(Gamepad, TheStickPointsTheWindAsTheCameraLooks) {
    for (const float yaw : {0.0f, 1.1f}) {
        WindControl wind({4, 0, 0});
        steer_by({.is_there = true, .left_right = 0.8f, .left_away = 0.1f}, yaw, 0.1f, wind);
        EXPECT_GT(as_seen(wind, yaw).x, 3.9f);
        steer_by({.is_there = true, .left_right = 0, .left_away = -1}, yaw, 0.1f, wind);
        EXPECT_LT(as_seen(wind, yaw).y, -3.9f);
        EXPECT_NEAR(wind.speed(), 4, 1e-5f);
    }
}

TEST(Gamepad, WhatNobodyHoldsDoesNothingAndTriggersMakeItFaster) {
    WindControl wind({0, 0, 2});
    const float before = wind.heading();
    steer_by({.is_there = true, .left_right = 0.1f, .left_away = -0.1f, .triggers = 0.02f}, 0, 1, wind);
    steer_by({.is_there = false, .left_right = 1, .triggers = 1}, 0, 1, wind);
    EXPECT_LT(apart(wind.heading(), before), 1e-6f);
    EXPECT_NEAR(wind.speed(), 2, 1e-6f);
    steer_by({.is_there = true, .triggers = 1}, 0, 0.5f, wind);
    EXPECT_NEAR(wind.speed(), 2 + WindControl::speed_rate, 1e-5f);
}

// Back in time, and each step twice.

constexpr float step_time = 1.0f / 60;

Simulation small_scene(const char* name) {
    return simulation_of(name, 200);
}

class Time : public testing::TestWithParam<const char*> {};

/// Twenty steps, back by twelve, and on again.
TEST_P(Time, BackAndOnAgainLeavesTheSameBytes) {
    Simulation simulation = small_scene(GetParam());
    Timeline timeline;
    std::vector<std::uint64_t> hashes;
    ASSERT_TRUE(timeline.keep(simulation));
    for (int k = 0; k < 20; ++k) {
        simulation.step(step_time);
        hashes.push_back(simulation.world().state_hash());
        ASSERT_TRUE(timeline.keep(simulation));
    }
    ASSERT_EQ(timeline.size(), 21u);
    ASSERT_TRUE(timeline.go_to(8, simulation));
    EXPECT_EQ(timeline.here(), 8u);
    EXPECT_EQ(simulation.world().state_hash(), hashes[7]);
    EXPECT_NEAR(simulation.time(), 8.0 / 60, 1e-6);
    for (std::size_t k = 8; k < 20; ++k) {
        simulation.step(step_time);
        ASSERT_EQ(simulation.world().state_hash(), hashes[k]) << "step " << k + 1;
        ASSERT_TRUE(timeline.keep(simulation));
        EXPECT_EQ(timeline.size(), k + 2) << "the other future is forgotten";
    }
}
INSTANTIATE_TEST_SUITE_P(Scenes, Time,
                         testing::Values("flag", "ribbon", "character", "ball", "meeting", "capes", "bar"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST(Timeline, KeepsWithinItsRoomTheLatest) {
    Simulation simulation = small_scene("flag");
    const std::size_t each = simulation.world().save_size();
    Timeline timeline(5 * each + 10);
    for (int k = 0; k < 12; ++k) {
        simulation.step(step_time);
        ASSERT_TRUE(timeline.keep(simulation));
        EXPECT_LE(timeline.bytes(), 5 * each + 10);
    }
    EXPECT_EQ(timeline.size(), 5u);
    EXPECT_EQ(timeline.here(), 4u);
    EXPECT_NEAR(timeline.time_of(0), 8.0 / 60, 1e-6);
    Timeline none(each - 1), one(each);
    ASSERT_TRUE(none.keep(simulation));
    EXPECT_EQ(none.size(), 0u);
    ASSERT_TRUE(one.keep(simulation));
    EXPECT_EQ(one.size(), 1u);
}

TEST(Timeline, NobodyHoldsWhatAHandHeldThen) {
    Simulation simulation = small_scene("flag");
    render::OrbitCamera camera = simulation.content().camera;
    Timeline timeline;
    Hands hands;
    WindControl wind;
    hands.begin(simulation);
    const auto pins = [&] {
        const auto positions = simulation.world().cloth(simulation.content().cloths.front().id)->positions;
        return std::ranges::count_if(positions, [](const Vec4& p) { return p.w == 0; });
    };
    const auto before = pins();
    Pointer pointer{.y = 0.45f, .left_button = true};
    for (pointer.x = 0.8f; pointer.x > 0.3f && !hands.interaction().grab().active(); pointer.x -= 0.03f) {
        hands.update({}, 1.6f, simulation, camera, wind);
        hands.update(pointer, 1.6f, simulation, camera, wind);
    }
    ASSERT_TRUE(hands.interaction().grab().active());
    hands.before_step(simulation, step_time);
    simulation.step(step_time);
    ASSERT_TRUE(timeline.keep(simulation, hands.mark()));
    EXPECT_EQ(pins(), before + 1);
    hands.update({}, 1.6f, simulation, camera, wind);
    EXPECT_EQ(pins(), before);
    const HandMark mark = timeline.mark_of(0);
    ASSERT_TRUE(hands.prepare(simulation, mark));
    ASSERT_TRUE(timeline.go_to(0, simulation));
    hands.arrive_in(simulation, mark);
    EXPECT_EQ(pins(), before);
}

TEST(Timeline, BeginsAnewWithACut) {
    Simulation simulation = small_scene("flag");
    Timeline timeline;
    for (int k = 0; k < 3; ++k) {
        simulation.step(step_time);
        ASSERT_TRUE(timeline.keep(simulation));
    }
    const Mesh& mesh = simulation.content().cloths.front().mesh;
    const std::uint32_t border = 4 * mesh.columns - 1;
    const MeshEdge edges[] = {{border, border - 1}, {border - 1, border - 2}};
    ASSERT_TRUE(simulation.cut(0, edges));
    ASSERT_EQ(simulation.cuts(), 1u);
    simulation.step(step_time);
    ASSERT_TRUE(timeline.keep(simulation));
    EXPECT_EQ(timeline.size(), 1u);
    EXPECT_EQ(timeline.bytes(), simulation.world().save_size());
    const std::uint64_t hash = simulation.world().state_hash();
    simulation.step(step_time);
    ASSERT_TRUE(timeline.go_to(0, simulation));
    EXPECT_EQ(simulation.world().state_hash(), hash);
}

TEST(RepeatCheck, FindsNothingWhereNothingDiffers) {
    Simulation simulation = small_scene("curtain"), once = small_scene("curtain");
    RepeatCheck check;
    check.enabled = true;
    const ClothId cloths[] = {simulation.content().cloths.front().id};
    for (int k = 0; k < 10; ++k) {
        simulation.before_step(step_time);
        check.step(simulation.world(), cloths, step_time);
        once.step(step_time);
    }
    EXPECT_EQ(check.checked(), 10u);
    EXPECT_FALSE(check.difference());
    EXPECT_EQ(simulation.world().state_hash(), once.world().state_hash());
    EXPECT_NE(words_of(check).find("10 steps"), std::string::npos);
}

TEST(RepeatCheck, ShowsTheFirstDifference) {
    Simulation simulation = small_scene("flags");
    RepeatCheck check;
    check.enabled = true;
    std::vector<ClothId> cloths;
    for (const SceneCloth& cloth : simulation.content().cloths) cloths.push_back(cloth.id);
    ASSERT_EQ(cloths.size(), 100u);
    for (int k = 0; k < 6; ++k) {
        if (k == 3)
            check.between = [&](World& world) {
                ASSERT_TRUE(world.move_cloth(cloths[1], {.translation = {0, 1e-4f, 0}}));
            };
        simulation.before_step(step_time);
        check.step(simulation.world(), cloths, step_time);
    }
    ASSERT_TRUE(check.difference());
    EXPECT_EQ(check.difference()->step, 4u);
    EXPECT_EQ(check.difference()->cloth, 1u);
    EXPECT_EQ(check.difference()->particle, 0u);
    EXPECT_NE(check.difference()->first, check.difference()->second);
    EXPECT_NE(words_of(check).find("step 4 differs, first in cloth 1"), std::string::npos) << words_of(check);
}

}  // namespace

}  // namespace weft::demo
