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

TEST(Drape, AFlatDiscShadesAllAndAHangingOneNothing) {
    EXPECT_FLOAT_EQ(drape_coefficient(std::numbers::pi_v<float> * 0.15f * 0.15f, 0.09f, 0.15f), 1);
    EXPECT_FLOAT_EQ(drape_coefficient(std::numbers::pi_v<float> * 0.09f * 0.09f, 0.09f, 0.15f), 0);
    const Mesh mesh = drape_disc(0.15f, 12, {0.3f, 0.5f, -0.2f});
    EXPECT_EQ(mesh.positions.size(), 1u + 3 * 12 * 13);
    auto world = World::create();
    const auto id = world->add_cloth(mesh);
    ASSERT_TRUE(id.ok()) << id.error().message;
    EXPECT_NEAR(shadow_area(mesh, *world->cloth(*id)), std::numbers::pi * 0.15 * 0.15, 3e-4);
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

TEST(Comparison, TheSameMethodIsTheSame) {
    Simulation shown = small_flag();
    const auto settings = shown.world().cloth_settings(shown.content().cloths.front().id);
    auto comparison = Comparison::start(shown, settings->method, Fairness::same_steps);
    ASSERT_TRUE(comparison.ok());
    for (int i = 0; i < 10; ++i) {
        shown.step(1.0f / 60);
        comparison->step(shown, 1.0f / 60);
    }
    EXPECT_EQ(comparison->shown().usual, comparison->other().usual);
}

TEST(Comparison, EqualTimeGivesTheCheaperMoreSteps) {
    EXPECT_EQ(balanced_substeps(1, 4, 1), 4);
    EXPECT_EQ(balanced_substeps(8, 1, 4), 2);
    EXPECT_EQ(balanced_substeps(3, 2, 2.1f), 3);
    EXPECT_EQ(balanced_substeps(1, 1, 50), 1);
    EXPECT_EQ(balanced_substeps(10, 100, 1), 64);
    EXPECT_EQ(balanced_substeps(5, 0, 1), 5) << "nothing measured yet";
}

}  // namespace
}  // namespace weft::demo
