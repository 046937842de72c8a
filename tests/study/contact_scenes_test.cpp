// Scenes of contact, and what is measured on them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "demo/study/contact/contact_measures.h"
#include "demo/study/contact/contact_result.h"
#include "demo/study/contact/contact_run.h"
#include "demo/study/contact/contact_table.h"
#include "demo/study/crossings/crossings.h"
#include "demo/study/crossings/triangle_distance.h"

namespace weft::study {
namespace {

struct Case {
    SceneMaker maker;
    SelfCollisionMethod method;
};

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const SceneMaker& maker : all_contact_scenes())
        for (const SelfCollisionMethod method :
             {SelfCollisionMethod::contact, SelfCollisionMethod::impact_zones})
            all.push_back({maker, method});
    return all;
}

std::string name_of_case(const testing::TestParamInfo<Case>& info) {
    std::string name = info.param.maker.name + "_" + name_of(info.param.method);
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    return name;
}

class ContactScenes : public testing::TestWithParam<Case> {};

TEST_P(ContactScenes, StartWellAndRun) {
    const SceneMaker& maker = GetParam().maker;
    if (maker.needs_garments && std::getenv("WEFT_DATA") == nullptr)
        GTEST_SKIP() << "WEFT_DATA is not set: no garments to test with";
    ContactRun run(maker.make(0), GetParam().method);
    EXPECT_EQ(run.scene().name, maker.name);
    EXPECT_GT(run.particles(), 50u);
    const EdgeStretch edges(run);
    EXPECT_NEAR(edges.of(run).mean, 1, 0.02) << "starts at about its rest lengths";
    EXPECT_LT(edges.of(run).most, maker.needs_garments ? 1.6 : 1.1) << "garments are draped already";
    const std::uint64_t crossings = count_crossings(run.soup()).all;
    if (run.scene().tangled) {
        EXPECT_GT(crossings, 90u);
        EXPECT_LT(crossings, 600u);
    } else {
        EXPECT_EQ(crossings, 0u);
    }
    for (int frame = 0; frame < 5; ++frame) run.step();
    EXPECT_TRUE(run.soup().finite());
    EXPECT_FALSE(has(run.world().report().flags, StepFlags::state_restored));
    EXPECT_FALSE(run.over());
    // Impact zones do not hold the stretch of a swung dress: one edge is longer.
    const bool is_loose = maker.needs_garments && GetParam().method == SelfCollisionMethod::impact_zones;
    EXPECT_LT(edges.of(run).most, is_loose ? 6 : 3.1);
    EXPECT_TRUE(std::isfinite(rms_speed(run)));
}

INSTANTIATE_TEST_SUITE_P(Study, ContactScenes, testing::ValuesIn(cases()), name_of_case);

ContactScene scene_named(const std::string& name) {
    for (const SceneMaker& maker : all_contact_scenes())
        if (maker.name == name) return maker.make(512);
    throw std::logic_error(name + " is no scene");
}

// At the first impact more layers come together in a step than its list of pairs has room for: halves have.
TEST(ContactRuns, LayersThatFallOnOneAnotherStayWhole) {
    for (const SceneMaker& maker : all_contact_scenes()) {
        if (maker.name != "folddrop") continue;
        ContactRun run(maker.make(0), SelfCollisionMethod::contact);
        const EdgeStretch edges(run);
        double worst = 0;
        for (int frame = 0; frame < 60; ++frame) {
            run.step();
            worst = std::max(worst, edges.of(run).most);
        }
        EXPECT_LT(worst, 1.4);
        EXPECT_EQ(count_crossings(run.soup()).all, 0u);
    }
}

TEST(ContactMeasures, LayersAreTheScenes) {
    for (const char* name : {"stack 5", "stack 5 of cloths"}) {
        const ContactRun run(scene_named(name), SelfCollisionMethod::off);
        const std::vector<double> heights = layer_heights(run);
        ASSERT_EQ(heights.size(), 5u) << name;
        EXPECT_EQ(layers_in_order(heights), 4u);
        EXPECT_NEAR(heights[0], 0.006, 1e-6);
        EXPECT_NEAR(heights[4] - heights[3], heights[1] - heights[0], 1e-6);
        EXPECT_NEAR(deepest_in_colliders(run), -0.001, 1e-6) << "5 mm are kept, 6 mm there";
    }
    EXPECT_EQ(layers_in_order({0, 2, 1, 3}), 2u);
}

TEST(ContactMeasures, WhatFliesInZeroGravityHasItsSpeedAndNoMomentum) {
    for (const char* name : {"zero gravity", "zero gravity of cloths"}) {
        ContactRun run(scene_named(name), SelfCollisionMethod::off);
        while (run.time() < run.scene().free_from + 0.05) run.step();
        EXPECT_NEAR(rms_speed(run), 0.5, 0.005) << name;
        EXPECT_NEAR(momentum(run).norm() / run.scene().free_momentum, 0, 1e-3) << name;
        EXPECT_NEAR(run.scene().free_momentum, 0.4 * 0.4 * 0.2, 1e-6);
    }
}

TEST(ContactMeasures, CrossingsBetweenClothsAreToldFromThoseWithin) {
    ContactRun run(scene_named("zero gravity of cloths"), SelfCollisionMethod::off);
    while (run.time() < 0.15) run.step();
    const CrossingCount count = count_crossings(run.soup());
    EXPECT_GT(count.all, 10u) << "nothing keeps them apart";
    EXPECT_EQ(count.between_bodies, count.all);
    EXPECT_EQ(least_gap(run.soup(), 1), 0);
}

TEST(Crossings, OfCrumpledClothAreThoseOfAllPairs) {
    ContactRun run(scene_named("folddrop"), SelfCollisionMethod::off);
    while (run.time() < 0.45) run.step();
    const TriangleSoup soup = run.soup();
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::uint32_t i = 0; i < soup.triangles.size(); ++i)
        for (std::uint32_t j = i + 1; j < soup.triangles.size(); ++j)
            if (triangles_cross(soup, i, j)) pairs.emplace_back(i, j);
    EXPECT_GT(pairs.size(), 50u);
    EXPECT_EQ(crossing_pairs(soup), pairs);
}

TEST(LeastGap, OfFoldedClothIsThatOfAllPairs) {
    const TriangleSoup soup = ContactRun(scene_named("folddrop"), SelfCollisionMethod::off).soup();
    const auto corners = [&](const Triangle& triangle) {
        Corners3 places;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& p = soup.points[triangle[k]];
            places[k] = Eigen::Vector3f(p.x, p.y, p.z).cast<double>();
        }
        return places;
    };
    double least = 1;
    for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
        for (std::uint32_t j = i + 1; j < soup.triangles.size(); ++j) {
            if (!soup.share_a_vertex(i, j))
                least =
                    std::min(least, squared_distance(corners(soup.triangles[i]), corners(soup.triangles[j])));
        }
    }
    EXPECT_DOUBLE_EQ(least_gap(soup, 1), std::sqrt(least));
    EXPECT_GT(least, 0);
}

TEST(ContactResult, TellsWhatPassedThrough) {
    const ContactScene scene = scene_named("cross-strips on edge");
    const ContactResult result = measure_contact(scene, SelfCollisionMethod::off, 1);
    EXPECT_GT(result.crossings_peak, 0u);
    EXPECT_EQ(result.crossings_final, 0u) << "it fell through, and on";
    EXPECT_EQ(result.layers, 2u);
    EXPECT_EQ(result.layers_in_order, 0u) << "and what was above is below";
    EXPECT_GT(result.clean_from, 0.05);
    EXPECT_LT(result.clean_from, scene.seconds / 2);
    EXPECT_EQ(result.gap, 0);
    EXPECT_GT(result.stretch_worst, 1);
    EXPECT_NEAR(result.stretch_mean, 1, 0.01);
    EXPECT_TRUE(std::isnan(result.rest_speed)) << "it falls to the end";
    EXPECT_TRUE(std::isnan(result.deepest)) << "there are no colliders";
    EXPECT_TRUE(std::isnan(result.momentum_drift)) << "weight acts";
    EXPECT_GT(result.median_step, 0);
}

}  // namespace
}  // namespace weft::study
