#include "engine/least_turn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace weft::test {
namespace {

Vector3 random_direction(std::mt19937& random) {
    std::normal_distribution<float> component;
    return Vector3::NullaryExpr([&](auto) { return component(random); });
}

TEST(LeastTurn, TakesOneDirectionToAnotherByTheAngleBetweenThem) {
    std::mt19937 random(1);
    for (int k = 0; k < 1000; ++k) {
        const Vector3 from = random_direction(random), to = random_direction(random);
        const Eigen::Quaternionf turn = least_turn(from, 1e3f * to);
        EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 2e-4f);
        EXPECT_NEAR(turn.norm(), 1, 1e-4f);
        EXPECT_NEAR(2 * std::acos(std::min(turn.w(), 1.0f)),
                    std::acos(from.normalized().dot(to.normalized())), 2e-3f);
    }
}

TEST(LeastTurn, IsAHalfTurnBetweenOppositeDirections) {
    std::mt19937 random(1);
    for (const float aside : {0.0f, 1e-7f, 1e-5f, 1e-4f, 1e-3f, 4e-3f, 5e-3f, 1e-2f, 4e-2f, 5e-2f}) {
        for (int k = 0; k < 100; ++k) {
            const Vector3 from = random_direction(random).normalized();
            const Vector3 to = -from + aside * from.cross(random_direction(random)).normalized();
            const Eigen::Quaternionf turn = least_turn(from, to);
            EXPECT_LT((turn * from - to.normalized()).norm(), 1e-3f) << aside << " aside";
            EXPECT_NEAR(turn.norm(), 1, 1e-4f) << aside << " aside";
        }
    }
}

TEST(LeastTurn, IsNoneBetweenEqualDirections) {
    EXPECT_EQ(least_turn({0, 2, 0}, {0, 3, 0}).w(), 1);
}

}  // namespace
}  // namespace weft::test
