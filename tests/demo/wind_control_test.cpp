#include "demo/window/wind_control.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace weft::demo
