// What a search makes of its memory, its threads and what it is given: the list, whatever features are in it.

#include <gtest/gtest.h>

#include <cstring>

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

}  // namespace
}  // namespace weft::test
