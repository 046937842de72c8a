// The wind's arrow and the gamepad.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "demo/hands/air/gamepad.h"
#include "demo/hands/air/wind_arrow.h"

namespace weft::demo {
namespace {

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

}  // namespace
}  // namespace weft::demo
