// The bench's closed forms, and two methods beside each other.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "demo/learn/comparison.h"
#include "demo/learn/drape.h"
#include "demo/learn/elastica.h"

namespace weft::demo {
namespace {

TEST(Elastica, HangsLikeABeamWhereItIsStiff) {
    const std::vector<Vec2> curve = elastica_curve(0.01, 11);
    ASSERT_EQ(curve.size(), 11u);
    EXPECT_NEAR(curve.back().y, -0.01 / 8, 1e-6) << "w l^4 / 8 E I";
    EXPECT_NEAR(curve.back().x, 1, 1e-5);
    EXPECT_EQ(curve.front().x, 0);
}

TEST(Elastica, HasPeircesAngle) {
    const std::vector<Vec2> curve = elastica_curve(8.0042, 101);
    const double chord =
        std::atan2(-static_cast<double>(curve.back().y), static_cast<double>(curve.back().x));
    EXPECT_NEAR(chord * 180 / std::numbers::pi, 41.5, 0.02)
        << "at which his bending length is half of the strip's";
    float length = 0;
    for (std::size_t i = 1; i < curve.size(); ++i)
        length += std::hypot(curve[i].x - curve[i - 1].x, curve[i].y - curve[i - 1].y);
    EXPECT_NEAR(length, 1, 1e-3);
}

Simulation small_flag() {
    SceneOptions options;
    options.particles = 200;
    Overrides overrides;
    overrides.threads = 1;
    return std::move(*Simulation::create(*find_scene("flag"), options, overrides));
}

TEST(Comparison, TheFinerOneIsNearerToTheExact) {
    Simulation shown = small_flag();
    auto comparison = Comparison::start(shown, Jacobi{.iterations = 1}, Fairness::same_steps);
    ASSERT_TRUE(comparison.ok()) << comparison.error().message;
    for (int i = 0; i < 30; ++i) {
        shown.step(1.0f / 60);
        comparison->step(shown, 1.0f / 60);
    }
    EXPECT_GT(comparison->shown().usual, 0);
    EXPECT_LT(comparison->shown().usual, 0.7f * comparison->other().usual);
    EXPECT_GE(comparison->other().farthest, comparison->other().usual);
    EXPECT_EQ(comparison->other().substeps, 1);
    EXPECT_GT(comparison->shown().milliseconds, 0);
}

}  // namespace
}  // namespace weft::demo
