#include "collision/contact/crossings/crossings.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <set>

#include "collision/contact/pairs/pair_finder.h"
#include "tests/collision/contact/contact_reference.h"
#include "tests/collision/contact/cuts.h"
#include "tests/targets/targets.h"

namespace weft::test {
namespace {

CrossingList crossings_of(const ContactScene& scene, int threads = 1, std::size_t capacity = 1 << 18) {
    PairFinder finder;
    finder.reserve(scene.bodies);
    Parallel parallel(threads);
    CrossingList list(capacity);
    finder.find_crossings(parallel, scene.bodies, scene.positions, list);
    return list;
}

using Five = std::array<std::uint32_t, 5>;

std::set<Five> set_of(const CrossingList& list) {
    std::set<Five> found;
    for (const Crossing& c : list.crossings.span().first(list.size)) {
        Five five = {c.edge[0], c.edge[1], c.triangle[0], c.triangle[1], c.triangle[2]};
        std::sort(five.begin(), five.begin() + 2);
        std::sort(five.begin() + 2, five.end());
        EXPECT_TRUE(found.insert(five).second) << "listed twice";
    }
    return found;
}

/// For scenes in which nothing touches.
bool cross(const Vec4& p, const Vec4& q, const Vec4& a, const Vec4& b, const Vec4& c) {
    const auto at = [](const Vec4& v) { return Eigen::Matrix<long double, 3, 1>(v.x, v.y, v.z); };
    return cuts(at(p), at(q), at(a), at(b), at(c));
}

void expect_as_reference(const ContactScene& scene, std::size_t at_least) {
    std::set<Five> expected;
    for (const ContactBody& a : scene.bodies)
        for (const ContactBody& b : scene.bodies) {
            if (!meet(a, b)) continue;
            for (const auto& edge : a.mesh->edges())
                for (const Triangle& t : b.mesh->triangles()) {
                    Five five = {a.first + edge[0], a.first + edge[1], b.first + t[0], b.first + t[1],
                                 b.first + t[2]};
                    if (std::find_first_of(five.begin(), five.begin() + 2, five.begin() + 2, five.end()) !=
                        five.begin() + 2)
                        continue;
                    const std::vector<Vec4>& x = scene.positions;
                    if (!cross(x[five[0]], x[five[1]], x[five[2]], x[five[3]], x[five[4]])) continue;
                    std::sort(five.begin(), five.begin() + 2);
                    std::sort(five.begin() + 2, five.end());
                    expected.insert(five);
                }
        }
    EXPECT_GE(expected.size(), at_least);
    EXPECT_EQ(set_of(crossings_of(scene)), expected);
}

std::vector<Vec4> level_grid(std::uint32_t side) {
    return grid_positions(side, side, [](float u, float v) { return Vec4{0.01f * u, 0, 0.01f * v, 0}; });
}

ContactScene crumpled(std::uint32_t side) {
    ContactScene scene;
    scene.add(level_grid(side), level_grid(side), grid_triangles(side, side), 0.003f);
    scene.jitter(0.015f);
    return scene;
}

TEST(Crossings, AsReference) {
    expect_as_reference(crumpled(20), 500);
    ContactScene far = crumpled(20);
    for (Vec4& p : far.positions) p = {p.x - 1000, p.y + 900, p.z + 1000, 0};
    far.jitter(0.01f, 3);
    expect_as_reference(far, 500);
    for (std::uint32_t seed = 1; seed < 4; ++seed) {
        const std::vector<Vec4> points = random_vectors(120, 1, seed);
        std::mt19937 random(seed);
        std::vector<Triangle> triangles(100);
        for (Triangle& t : triangles)
            for (std::uint32_t& i : t) i = std::uint32_t(random() % points.size());
        ContactScene scene;
        scene.add(points, points, triangles, 1);
        expect_as_reference(scene, 100);
    }
}

TEST(Crossings, OfBodiesThatMeet) {
    ContactScene scene;
    for (std::uint32_t k = 0; k < 3; ++k) {
        scene.add(level_grid(12), level_grid(12), grid_triangles(12, 12), 0.003f);
        scene.bodies[k].meets_itself = k != 1;
    }
    scene.jitter(0.008f);
    expect_as_reference(scene, 1000);
    scene.bodies[0].layer = 2;
    scene.bodies[2].mask = 1;
    expect_as_reference(scene, 500);
}

TEST(Crossings, WhatLiesInAPlaneDoesNotCross) {
    ContactScene scene;
    for (int k = 0; k < 2; ++k) {
        std::vector<Vec4> now = level_grid(12);
        for (Vec4& p : now) p.x += 0.0037f * float(k);
        scene.add(level_grid(12), now, grid_triangles(12, 12), 0.003f);
    }
    EXPECT_EQ(crossings_of(scene).size, 0u);
}

TEST(Crossings, ALineThroughSidesAndCornersIsSeen) {
    const std::vector<Vec4> sheet = level_grid(6);
    for (const auto& [x, z] : {std::pair(0.02f, 0.02f), {0.025f, 0.02f}, {0.02f, 0.035f}, {0.025f, 0.025f}}) {
        ContactScene scene;
        scene.add(sheet, sheet, grid_triangles(6, 6), 0.003f);
        const std::vector<Vec4> needle = {{x, -0.1f, z, 0}, {x, 0.1f, z, 0}, {x + 1, 0.1f, z, 0}};
        scene.add(needle, needle, {{0, 1, 2}}, 0.003f);
        EXPECT_TRUE(std::ranges::any_of(set_of(crossings_of(scene)),
                                        [](const Five& c) { return c[0] == 36 && c[1] == 37; }))
            << x << " " << z;
    }
}

TEST(Crossings, TheListDoesNotDependOnThreadsAndEndsWhereRoomDoes) {
    const ContactScene scene = crumpled(48);
    const CrossingList all = crossings_of(scene);
    ASSERT_GT(all.size, 2000u);
    for (const std::uint32_t capacity : {0u, 1u, 1000u, all.size - 1, all.size}) {
        for (const int threads : {1, 2, 4}) {
            const CrossingList list = crossings_of(scene, threads, capacity);
            EXPECT_EQ(list.overflowed, capacity < all.size);
            ASSERT_EQ(list.size, capacity);
            EXPECT_EQ(std::memcmp(list.crossings.data(), all.crossings.data(), capacity * sizeof(Crossing)),
                      0);
        }
    }
}

TEST(Crossings, WhatIsNotFiniteCrossesNothing) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                    inf = std::numeric_limits<float>::infinity();
    const ContactScene scene = crumpled(16);
    ContactScene spoilt = scene;
    spoilt.positions[40] = {nan, 0, 0, 0};
    spoilt.positions[99] = {0, 0, -inf, 0};
    std::set<Five> expected = set_of(crossings_of(scene));
    std::erase_if(expected, [](const Five& c) {
        return std::ranges::any_of(c, [](std::uint32_t i) { return i == 40 || i == 99; });
    });
    EXPECT_EQ(set_of(crossings_of(spoilt)), expected);
}

TEST(Crossings, AsReferenceOnEveryVectorTarget) {
    for (const std::int64_t target : vector_targets()) {
        use_target(target);
        expect_as_reference(crumpled(16), 300);
    }
    use_target(0);
}

}  // namespace
}  // namespace weft::test
