// What a search makes of its memory, its threads and what it is given: the list, whatever features are in it.

#include <gtest/gtest.h>

#include <cstring>

#include "collision/contact/narrowing.h"
#include "pair_finder_scenes.h"

namespace weft::test {
namespace {

ContactScene crowded() {
    ContactScene scene = folded(64, 0.3f);
    scene.add_motions(random_vectors(scene.positions.size(), 0.1f * edge, 2));
    return scene;
}

void expect_equal(const PairList& a, const PairList& b) {
    ASSERT_EQ(a.size, b.size);
    EXPECT_EQ(a.vertex_triangle, b.vertex_triangle);
    EXPECT_EQ(a.overflowed, b.overflowed);
    EXPECT_EQ(std::memcmp(a.pairs.data(), b.pairs.data(), a.size * sizeof(FeaturePair)), 0);
    EXPECT_EQ(std::memcmp(a.shapes.data(), b.shapes.data(), a.size * sizeof(PairShape)), 0);
}

TEST(PairFinder, TheListDoesNotDependOnThreads) {
    const ContactScene scene = crowded();
    const PairList expected = pairs_of(scene);
    ASSERT_GT(expected.size, 10000u);
    for (const int threads : {2, 4}) expect_equal(pairs_of(scene, threads), expected);
}

TEST(PairFinder, WhatDoesNotFitIsLeftOutFromTheEnd) {
    const ContactScene scene = crowded();
    const PairList all = pairs_of(scene);
    for (const std::uint32_t capacity : {0u, 1u, 100u, all.vertex_triangle, all.size - 1, all.size}) {
        const PairList list = pairs_of(scene, 2, capacity);
        EXPECT_EQ(list.overflowed, capacity < all.size);
        ASSERT_EQ(list.size, capacity);
        EXPECT_EQ(list.vertex_triangle, std::min(capacity, all.vertex_triangle));
        EXPECT_EQ(std::memcmp(list.pairs.data(), all.pairs.data(), capacity * sizeof(FeaturePair)), 0);
        EXPECT_EQ(std::memcmp(list.shapes.data(), all.shapes.data(), capacity * sizeof(PairShape)), 0);
    }
}

TEST(PairFinder, AMemoryThatIsTooSmallForABlockDoesNotShow) {
    ContactScene scene = waving(16, 0);
    for (Vec4& p : scene.positions) p = {0.02f * p.x, 0, 0.02f * p.z, 0};
    scene.jitter(0.3f * edge);
    scene.bodies[0].reach = edge;
    const PairList expected = pairs_of(scene, 1, 1 << 20);
    EXPECT_FALSE(expected.overflowed);
    EXPECT_GT(expected.size, 200000u);
    expect_equal(pairs_of(scene, 2, 1 << 20), expected);
}

// A World's islands differ from step to step, and share one finder.
TEST(PairFinder, FewerBodiesAreSearchedAsByAFinderOfTheirOwn) {
    constexpr std::uint32_t side = 300;  // so many blocks that they take two groups of groups
    ContactScene small = folded(20, 0.3f), all = sheet(side, 0.3f * edge, flat(side, side));
    for (Vec4& p : small.positions) {  // over the part of the large one that is searched last
        p.x += 0.9f * edge * side;
        p.z += 0.9f * edge * side;
    }
    const std::vector<Triangle> triangles = grid_triangles(20, 20);
    all.add(small.positions, small.positions, triangles, 0.3f * edge);
    PairFinder finder;
    finder.reserve(all.bodies);
    Parallel serial(1);
    PairList of_all(1 << 18), found(1 << 18);
    finder.find(serial, all.bodies, all.positions, all.motions, of_all);
    ContactBody alone = all.bodies[1];
    alone.first = 0;
    finder.find(serial, std::span(&alone, 1), small.positions, small.motions, found);
    ContactScene own;
    own.add(small.positions, small.positions, triangles, 0.3f * edge);
    expect_equal(found, pairs_of(own));
}

TEST(PairFinder, OfPairsNearestAtABorderAPartOfTheReachCounts) {
    const ContactScene scene = crowded();
    const PairList all = pairs_of(scene), list = pairs_of(scene, 1, 1 << 18, 0.5f);
    const double reach = 0.5 * double{scene.bodies[0].reach};
    std::uint32_t k = 0, left_out = 0;
    for (std::uint32_t of_all = 0; of_all < all.size; ++of_all) {
        const FeaturePair& pair = all.pairs[of_all];
        const bool is_listed = k < list.size && list.pairs[k].corners == pair.corners;
        const double gap =
            reference_pair(pair.corners, all.corners_of_a(of_all), scene.positions, scene.motions).swept_gap;
        if (std::abs(gap - reach) > 1e-3 * reach) {
            EXPECT_EQ(is_listed, !all.shapes[of_all].is_at_border() || gap < reach) << of_all;
        }
        k += is_listed;
        left_out += !is_listed;
    }
    EXPECT_EQ(k, list.size);
    EXPECT_GT(left_out, all.size / 10);
    EXPECT_GT(list.size, all.size / 10);
}

/// Each ends within `slack` of the way from 0 to the motion.
std::vector<Vec4> near_these(const std::vector<Vec4>& motions, float slack) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> part(0, 1);
    std::vector<Vec4> ends = random_vectors(motions.size(), slack / std::sqrt(3.0f), 6);
    for (std::size_t i = 0; i < ends.size(); ++i)
        set_xyz(ends[i], xyz(ends[i]) + part(random) * xyz(motions[i]));
    return ends;
}

float longest_of(const std::vector<Vec4>& motions) {
    float longest = 0;
    for (const Vec4& m : motions) longest = std::max(longest, xyz(m).norm());
    return longest;
}

TEST(PairNarrowing, LeavesWhatASearchWithTheShorterReachFinds) {
    ContactScene wide = crowded();
    PairNarrowing narrowing;
    narrowing.reserve(1 << 18);
    constexpr float of_borders = 0.8f;
    for (const float reach : {0.12f, 0.16f, 0.2f}) {
        ContactScene narrow = wide;
        narrow.bodies[0].reach = reach * edge;
        narrow.motions = near_these(wide.motions, 0.49f * (of_borders * wide.bodies[0].reach - reach * edge));
        const PairList searched = pairs_of(narrow);
        EXPECT_GT(searched.size, 10u);
        for (const int threads : {1, 3}) {
            PairList list = pairs_of(wide, 1, 1 << 18, of_borders);
            EXPECT_GT(list.size, searched.size + 1000);
            Parallel parallel(threads);
            narrowing.narrow(parallel, narrow.positions, narrow.motions, reach * edge,
                             longest_of(narrow.motions), list);
            expect_equal(list, searched);
        }
    }
}

TEST(PairNarrowing, OfAListWithoutPairsNothingIsLeft) {
    PairNarrowing narrowing;
    narrowing.reserve(100);
    PairList list(100);
    Parallel serial(1);
    narrowing.narrow(serial, {}, {}, 1, 0, list);
    EXPECT_EQ(list.size, 0u);
}

}  // namespace
}  // namespace weft::test
