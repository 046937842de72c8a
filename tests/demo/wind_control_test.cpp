#include "demo/window/wind_control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace weft::demo {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

TEST(WindControl, GivesBackTheWindThatItTook) {
    for (const Vec3 wind :
         {Vec3{3, 0.5f, -4}, Vec3{-1, 0, 0}, Vec3{0, -2, 7}, Vec3{0, 1, 0}, Vec3{60, 5, -70}}) {
        const Vec3 back = WindControl(wind).velocity();
        EXPECT_NEAR(back.x, wind.x, 1e-5);
        EXPECT_EQ(back.y, wind.y);
        EXPECT_NEAR(back.z, wind.z, 1e-5);
    }
}

TEST(WindControl, HeadingIsAnticlockwiseSeenFromAbove) {
    EXPECT_NEAR(WindControl({5, 0, 0}).heading(), 0, 1e-6);
    // From above, with +X to the right, -Z is away from the viewer: a quarter turn to the left.
    EXPECT_NEAR(WindControl({0, 0, -5}).heading(), pi / 2, 1e-6);
    EXPECT_NEAR(WindControl({0, 0, 5}).heading(), -pi / 2, 1e-6);
}

TEST(WindControl, KeysTurnAtTheirRateAndKeepTheSpeed) {
    WindControl wind({4, 0, 0});
    for (int i = 0; i < 30; ++i) wind.steer(1, 0, 1.0f / 60.0f);
    EXPECT_NEAR(wind.heading(), 0.5f * WindControl::turn_rate, 1e-4);
    EXPECT_NEAR(wind.speed(), 4, 1e-6);
    for (int i = 0; i < 30; ++i) wind.steer(-1, 0, 1.0f / 60.0f);
    EXPECT_NEAR(wind.heading(), 0, 1e-4);
}

TEST(WindControl, SpeedStaysInItsRange) {
    WindControl wind({1, 0, 0});
    wind.steer(0, -1, 10);
    EXPECT_EQ(wind.speed(), 0);
    wind.steer(0, 1, 1000);
    EXPECT_EQ(wind.speed(), WindControl::max_speed);
}

TEST(WindControl, StillAirRemembersItsHeading) {
    WindControl wind({0, 0, -3});
    wind.steer(0, -1, 10);
    EXPECT_EQ(std::hypot(wind.velocity().x, wind.velocity().z), 0);
    wind.steer(0, 1, 0.5f);
    EXPECT_NEAR(wind.velocity().x, 0, 1e-5);
    EXPECT_NEAR(wind.velocity().z, -0.5f * WindControl::speed_rate, 1e-5);
}

TEST(WindControl, HeadingStaysWithinHalfATurn) {
    WindControl wind({1, 0, 0});
    for (const float heading : {-20.0f, -pi, -0.1f, 0.0f, 3.0f, pi, 7.0f, 100.0f}) {
        wind.set_heading(heading);
        EXPECT_GT(wind.heading(), -pi - 1e-4f);
        EXPECT_LE(wind.heading(), pi + 1e-4f);
        EXPECT_NEAR(std::cos(wind.heading()), std::cos(heading), 1e-4);
        EXPECT_NEAR(std::sin(wind.heading()), std::sin(heading), 1e-4);
    }
}

}  // namespace
}  // namespace weft::demo
