// Crossing triangles, and the scenes that are judged by them.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "demo/study/contact/contact_run.h"
#include "demo/study/contact/contact_table.h"
#include "demo/study/crossings/crossings.h"
#include "demo/study/crossings/triangle_geometry.h"

namespace weft::study {

// The count of triangles that cross, against integers and against shapes that are known.

namespace {

__extension__ using Wide = __int128;
using Whole = std::array<std::int64_t, 3>;
using WholeTriangle = std::array<Whole, 3>;

Whole less(const Whole& p, const Whole& q) {
    return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

Whole cross_product(const Whole& p, const Whole& q) {
    return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

std::int64_t dot(const Whole& p, const Whole& q) {
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

struct Fraction {
    Wide over, under;  // under > 0
    friend bool operator<(const Fraction& a, const Fraction& b) {
        return a.over * b.under < b.over * a.under;
    }
};

/// Where the inside of a triangle meets a plane, along one of the axes: the interval's two ends, none if it
/// does not.
std::vector<Fraction> stretch(const WholeTriangle& t, const std::array<std::int64_t, 3>& heights,
                              std::size_t axis) {
    std::vector<Fraction> ends;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const std::int64_t here = heights[k], there = heights[next];
        if (here == 0) ends.push_back({t[k][axis], 1});
        if ((here > 0 && there < 0) || (here < 0 && there > 0)) {
            const std::int64_t sign = here > there ? 1 : -1;
            ends.push_back({Wide(sign) * (Wide(t[next][axis]) * here - Wide(t[k][axis]) * there),
                            Wide(sign) * (here - there)});
        }
    }
    std::ranges::sort(ends, [](const Fraction& a, const Fraction& b) { return a < b; });
    return ends;
}

/// By fractions of whole numbers up to 2^14: the rule as the header says it, computed as nowhere else.
bool known_to_cross(const WholeTriangle& a, const WholeTriangle& b) {
    const auto normal = [](const WholeTriangle& t) {
        return cross_product(less(t[1], t[0]), less(t[2], t[0]));
    };
    const auto heights = [&](const WholeTriangle& plane, const WholeTriangle& t) {
        const Whole n = normal(plane);
        return std::array{dot(n, less(t[0], plane[0])), dot(n, less(t[1], plane[0])),
                          dot(n, less(t[2], plane[0]))};
    };
    const auto of_a = heights(b, a), of_b = heights(a, b);
    for (const auto& h : {of_a, of_b})
        if (std::ranges::min(h) >= 0 || std::ranges::max(h) <= 0) return false;
    const Whole na = normal(a), nb = normal(b);
    // The line's direction overflows 64 bits: only which coordinate of it is greatest is needed.
    std::array<Wide, 3> line;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
        line[k] = Wide(na[l]) * nb[m] - Wide(na[m]) * nb[l];
        if (line[k] < 0) line[k] = -line[k];
    }
    const auto axis = static_cast<std::size_t>(std::ranges::max_element(line) - line.begin());
    const auto in_a = stretch(a, of_a, axis), in_b = stretch(b, of_b, axis);
    return std::max(in_a.front(), in_b.front()) < std::min(in_a.back(), in_b.back());
}

/// Points of whole numbers in boxes of that size, all of them `from` the origin, and a factor that is a power
/// of two: floats hold them exactly.
struct Soup {
    std::vector<Whole> points;
    TriangleSoup soup;

    void add_triangle(const WholeTriangle& triangle, std::int64_t from, float factor) {
        const auto first = static_cast<std::uint32_t>(points.size());
        for (const Whole& p : triangle) {
            points.push_back(p);
            const auto at = [&](std::size_t k) { return factor * static_cast<float>(p[k] + from); };
            soup.points.push_back({at(0), at(1), at(2)});
        }
        soup.triangles.push_back({first, first + 1, first + 2});
        soup.bodies.push_back(first % 2);
    }
    [[nodiscard]] WholeTriangle whole(std::size_t t) const {
        return {points[3 * t], points[3 * t + 1], points[3 * t + 2]};
    }
};

std::vector<std::pair<std::uint32_t, std::uint32_t>> brute_force(const Soup& soup) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    const auto count = static_cast<std::uint32_t>(soup.soup.triangles.size());
    for (std::uint32_t i = 0; i < count; ++i)
        for (std::uint32_t j = i + 1; j < count; ++j)
            if (known_to_cross(soup.whole(i), soup.whole(j))) pairs.emplace_back(i, j);
    return pairs;
}

struct SoupKind {
    std::string name;
    std::int64_t size;  // of a triangle's box
    std::int64_t room;  // of the box in which these are
    std::int64_t from;  // the origin
    float factor;
    std::array<std::int64_t, 3> flattened;  // each coordinate is a multiple of these
};

class RandomSoups : public testing::TestWithParam<SoupKind> {};

TEST_P(RandomSoups, AreCountedAsWholeNumbersSay) {
    const SoupKind& kind = GetParam();
    std::mt19937 random(7);
    const auto up_to = [&](std::int64_t most) {
        return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(most + 1));
    };
    std::size_t crossings = 0;
    for (int round = 0; round < 40; ++round) {
        Soup soup;
        for (int t = 0; t < 60; ++t) {
            WholeTriangle triangle;
            const Whole corner{up_to(kind.room), up_to(kind.room), up_to(kind.room)};
            for (Whole& p : triangle) {
                for (std::size_t k = 0; k < 3; ++k) {
                    p[k] = corner[k] + up_to(kind.size);
                    p[k] -= p[k] % kind.flattened[k];
                }
            }
            soup.add_triangle(triangle, kind.from, kind.factor);
        }
        const auto known = brute_force(soup);
        EXPECT_EQ(crossing_pairs(soup.soup), known) << "round " << round;
        EXPECT_EQ(count_crossings(soup.soup).all, known.size());
        crossings += known.size();
    }
    if (kind.flattened[1] <= kind.room) {
        EXPECT_GT(crossings, 100u) << "too few to tell";
    } else {
        EXPECT_EQ(crossings, 0u) << "all lie in one plane";
    }
}

INSTANTIATE_TEST_SUITE_P(Crossings, RandomSoups,
                         testing::Values(SoupKind{"random", 8000, 8000, 0, 1, {1, 1, 1}},
                                         SoupKind{"scattered", 3000, 12000, 0, 1.0f / 1024, {1, 1, 1}},
                                         SoupKind{"clustered", 6, 3, 0, 1, {1, 1, 1}},
                                         SoupKind{"degenerate", 2, 1, 0, 0.25f, {1, 1, 1}},
                                         SoupKind{"layered", 4000, 4000, 0, 1, {1, 2000, 1}},
                                         SoupKind{"planar", 4000, 4000, 0, 1, {1, 16000, 1}},
                                         SoupKind{"far", 40, 40, (1 << 24) - 100, 0x1p-10f, {1, 1, 1}},
                                         SoupKind{"tiny", 900, 900, 0, 0x1p-120f, {1, 1, 1}},
                                         SoupKind{"huge", 900, 900, 1000, 0x1p100f, {1, 1, 1}}),
                         [](const auto& info) { return info.param.name; });

TriangleSoup two_triangles(const std::array<Vec3, 6>& points) {
    TriangleSoup soup;
    soup.points = {points.begin(), points.end()};
    soup.triangles = {{0, 1, 2}, {3, 4, 5}};
    soup.bodies = {0, 1};
    return soup;
}

constexpr Vec3 p{0, 0, 0}, q{4, 0, 0}, r{0, 0, 4};  // a face on the ground

TEST(LeastGap, IsThatOfTheClosestTwo) {
    EXPECT_NEAR(least_gap(two_triangles({p, q, r, {1, 0.25f, 1}, {1, 1, 1}, {2, 1, 1}}), 9), 0.25, 1e-12);
    EXPECT_NEAR(least_gap(two_triangles({p, q, r, {-1, 0.5f, 1}, {1, 0.5f, -1}, {-1, 5, -1}}), 9), 0.5,
                1e-12);
    EXPECT_EQ(least_gap(two_triangles({p, q, r, {1, -1, 1}, {1, 1, 1}, {9, 1, 1}}), 9), 0);
    EXPECT_EQ(least_gap(two_triangles({p, q, r, {1, 8, 1}, {1, 9, 1}, {9, 9, 1}}), 2), 2) << "the bound";
    TriangleSoup many;
    for (int k = 0; k < 50; ++k) {
        const float h = static_cast<float>(k) + (k == 30 ? 0.125f : 0.0f);
        many.add_body({{0, h, 0}, {1, h, 0}, {0, h, 1}}, {{0, 1, 2}});
    }
    EXPECT_NEAR(least_gap(many, 9), 0.875, 1e-6);
}

// Scenes of contact, and what is measured on them.

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
