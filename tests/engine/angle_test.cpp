// Angles are those of the standard library.

#include "engine/angle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace weft {
namespace {

TEST(Angle, IsThatOfTheStandardLibrary) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> size(-40, 40), sign(-1, 1);
    for (int i = 0; i < 20000; ++i) {
        const double y = std::copysign(std::exp2(size(random)), sign(random));
        const double x = std::copysign(std::exp2(size(random)), sign(random));
        const double known = std::atan2(y, x);
        ASSERT_NEAR(angle_of(y, x), known, 5e-16 * std::abs(known)) << y << ", " << x;
    }
}

TEST(Angle, OfAxesIsExact) {
    for (const double y : {0.0, -0.0, 1.0, -1.0, std::numeric_limits<double>::infinity()})
        for (const double x : {0.0, -0.0, 1.0, -1.0}) {
            const double angle = angle_of(y, x), known = std::atan2(y, x);
            EXPECT_EQ(angle, known) << y << ", " << x;
            EXPECT_EQ(std::signbit(angle), std::signbit(known)) << y << ", " << x;
        }
}

}  // namespace
}  // namespace weft
