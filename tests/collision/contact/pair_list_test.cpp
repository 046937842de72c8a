// What a search makes of its memory, its threads and what it is given: the list, whatever features are in it.

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <set>

#include "collision/contact/pairs/narrowing.h"
#include "tests/cloth/as_for_threads.h"
#include "tests/collision/contact/pair_finder_scenes.h"
#include "tests/collision/contact/pair_list_reference.h"
#include "tests/laid_out.h"

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
    const LaidOut<PairList> expected = pairs_of(scene);
    ASSERT_GT(expected.size, 10000u);
    for (const int threads : {2, 4}) expect_equal(pairs_of(scene, threads), expected);
}

TEST(PairFinder, WhatDoesNotFitIsLeftOutFromTheEnd) {
    const ContactScene scene = crowded();
    const LaidOut<PairList> all = pairs_of(scene);
    for (const std::uint32_t capacity : {0u, 1u, 100u, all.vertex_triangle, all.size - 1, all.size}) {
        const LaidOut<PairList> list = pairs_of(scene, 2, capacity);
        EXPECT_EQ(list.overflowed, capacity < all.size);
        ASSERT_EQ(list.size, capacity);
        EXPECT_EQ(list.vertex_triangle, std::min(capacity, all.vertex_triangle));
        EXPECT_EQ(std::memcmp(list.pairs.data(), all.pairs.data(), capacity * sizeof(FeaturePair)), 0);
        EXPECT_EQ(std::memcmp(list.shapes.data(), all.shapes.data(), capacity * sizeof(PairShape)), 0);
    }
}

/// Sheets of 16 x 16 that are crushed to within an edge of one another: nearly every pair is near.
ContactScene crushed(std::uint32_t sheets) {
    ContactScene scene;
    for (std::uint32_t k = 0; k < sheets; ++k) {
        std::vector<Vec4> now = flat(16, 16);
        for (Vec4& p : now) p = {0.02f * p.x, 0, 0.02f * p.z, 0};
        scene.add(flat(16, 16), now, grid_triangles(16, 16), edge);
    }
    scene.jitter(0.3f * edge);
    return scene;
}

// A full list costs what a list of as many pairs costs: the search counts no more than what it may list, of
// both kinds, and what each thread tests at a time.
TEST(PairFinder, CountsNoMorePairsThanAFullListHasRoomFor) {
    constexpr std::uint64_t capacity = 1 << 14, at_a_time = 2048;
    for (const std::uint32_t sheets : {1u, 10u, 80u}) {
        const ContactScene scene = crushed(sheets);
        LaidOut<PairFinder> finder;
        finder.reserve(scene.bodies, room_for_pairs);
        LaidOut<PairList> first(capacity), list(capacity);
        for (const std::uint32_t threads : {1u, 4u}) {
            SCOPED_TRACE(testing::Message() << sheets << " sheets, " << threads << " threads");
            Parallel parallel(static_cast<int>(threads));
            finder.find(parallel, scene.bodies, scene.positions, scene.motions, list);
            EXPECT_TRUE(list.overflowed);
            EXPECT_LE(finder.counted(), (threads == 1 ? 2 : 4) * capacity + threads * at_a_time);
            if (threads == 1)
                std::swap(first, list);
            else
                expect_equal(list, first);
            finder.find(parallel, scene.bodies, scene.positions, scene.motions, list, 1, FullList::is_empty);
            EXPECT_TRUE(list.overflowed);
            EXPECT_EQ(list.size, 0u);
            EXPECT_LE(finder.counted(), capacity + threads * at_a_time);
        }
        Parallel backwards = as_for_threads(2);
        backwards.lend([&] { finder.find(backwards, scene.bodies, scene.positions, scene.motions, list); });
        expect_equal(list, first);
    }
}

TEST(PairFinder, AListThatIsToBeEmptyWhereItIsFullIsWholeWhereItIsNot) {
    const ContactScene scene = crowded();
    const LaidOut<PairList> expected = pairs_of(scene);
    LaidOut<PairFinder> finder;
    finder.reserve(scene.bodies, room_for_pairs);
    Parallel serial(1);
    LaidOut<PairList> list(expected.size);
    finder.find(serial, scene.bodies, scene.positions, scene.motions, list, 1, FullList::is_empty);
    expect_equal(list, expected);
    LaidOut<PairList> shorter(expected.size - 1);
    finder.find(serial, scene.bodies, scene.positions, scene.motions, shorter, 1, FullList::is_empty);
    EXPECT_TRUE(shorter.overflowed);
    EXPECT_EQ(shorter.size + shorter.vertex_triangle, 0u);
}

TEST(PairFinder, APoolThatIsTooSmallDoesNotShow) {
    constexpr std::size_t capacity = 1 << 20;
    const ContactScene scene = crushed(1);
    const LaidOut<PairList> expected = pairs_of(scene, 1, capacity);
    EXPECT_FALSE(expected.overflowed);
    EXPECT_GT(expected.size, 200000u);
    for (const std::size_t pool : {std::size_t{0}, capacity / 16, capacity}) {
        LaidOut<PairFinder> finder;
        finder.reserve(scene.bodies, pool);
        Parallel parallel(2);
        LaidOut<PairList> list(capacity);
        finder.find(parallel, scene.bodies, scene.positions, scene.motions, list);
        expect_equal(list, expected);
    }
}

// A World's groups differ from step to step, and share one finder.
TEST(PairFinder, FewerBodiesAreSearchedAsByAFinderOfTheirOwn) {
    constexpr std::uint32_t side = 300;  // so many blocks that they take two groups of groups
    ContactScene small = folded(20, 0.3f), all = sheet(side, 0.3f * edge, flat(side, side));
    for (Vec4& p : small.positions) {  // over the part of the large one that is searched last
        p.x += 0.9f * edge * side;
        p.z += 0.9f * edge * side;
    }
    const std::vector<Triangle> triangles = grid_triangles(20, 20);
    all.add(small.positions, small.positions, triangles, 0.3f * edge);
    LaidOut<PairFinder> finder;
    finder.reserve(all.bodies, room_for_pairs);
    Parallel serial(1);
    LaidOut<PairList> of_all(1 << 18), found(1 << 18);
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
    const LaidOut<PairList> all = pairs_of(scene), list = pairs_of(scene, 1, 1 << 18, 0.5f);
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
    LaidOut<PairNarrowing> narrowing;
    narrowing.reserve(1 << 18);
    constexpr float of_borders = 0.8f;
    for (const float reach : {0.12f, 0.16f, 0.2f}) {
        ContactScene narrow = wide;
        narrow.bodies[0].reach = reach * edge;
        narrow.motions = near_these(wide.motions, 0.49f * (of_borders * wide.bodies[0].reach - reach * edge));
        const LaidOut<PairList> searched = pairs_of(narrow);
        EXPECT_GT(searched.size, 10u);
        for (const int threads : {1, 3}) {
            LaidOut<PairList> list = pairs_of(wide, 1, 1 << 18, of_borders);
            EXPECT_GT(list.size, searched.size + 1000);
            Parallel parallel(threads);
            narrowing.narrow(parallel, narrow.positions, narrow.motions, reach * edge,
                             longest_of(narrow.motions), list);
            expect_equal(list, searched);
        }
    }
}

TEST(PairNarrowing, OfAListWithoutPairsNothingIsLeft) {
    LaidOut<PairNarrowing> narrowing;
    narrowing.reserve(100);
    LaidOut<PairList> list(100);
    Parallel serial(1);
    narrowing.narrow(serial, {}, {}, 1, 0, list);
    EXPECT_EQ(list.size, 0u);
}

/// Corners of the pairs of one kind, each once.
std::set<std::array<std::uint32_t, 4>> corners_of(const PairList& list, bool vertex_triangle) {
    std::set<std::array<std::uint32_t, 4>> all;
    for (std::uint32_t k = vertex_triangle ? 0 : list.vertex_triangle;
         k < (vertex_triangle ? list.vertex_triangle : list.size); ++k)
        all.insert(list.pairs[k].corners);
    return all;
}

// A list without the pairs of marked particles gets these again, and of their patches at most what find()
// lists. Searches with motions that are no others open no neighbours.
TEST(PairFinder, FindsMoreWhereParticlesAreMarked) {
    for (const bool moving : {false, true}) {
        ContactScene scene = folded(30, 0.3f);
        if (moving) scene.add_motions(random_vectors(scene.positions.size(), 0.1f * edge, 2));
        LaidOut<PairFinder> finder;
        finder.reserve(scene.bodies, room_for_pairs);
        Parallel parallel(1);
        LaidOut<PairList> all(1 << 18);
        finder.find(parallel, scene.bodies, scene.positions, scene.motions, all, 1, FullList::has_the_first,
                    Parts::alike);
        ASSERT_GT(all.vertex_triangle, 50u);
        ASSERT_GT(all.size - all.vertex_triangle, 50u);
        for (const std::uint32_t marked : {0u, 1u, 20u, 900u}) {
            std::vector<std::uint8_t> marks(scene.positions.size());
            for (std::uint32_t k = 0; k < marked; ++k) marks[(k * 619 + 17) % marks.size()] = 1;
            LaidOut<PairList> list(1 << 18);
            for (std::uint32_t k = 0; k < all.size; ++k) {
                const auto& corners = all.pairs[k].corners;
                if (std::ranges::any_of(corners, [&](std::uint32_t i) { return marks[i] != 0; })) continue;
                list.vertex_triangle += k < all.vertex_triangle ? 1 : 0;
                list.shapes[list.size] = all.shapes[k];
                list.pairs[list.size++] = all.pairs[k];
            }
            const std::uint32_t left = list.size;
            finder.find_more(parallel, scene.bodies, scene.positions, scene.motions, marks, list);
            EXPECT_FALSE(list.overflowed);
            EXPECT_EQ(corners_of(list, true), corners_of(all, true)) << marked;
            EXPECT_EQ(corners_of(list, false), corners_of(all, false)) << marked;
            if (marked == 0) {
                EXPECT_EQ(list.size, left);
            } else if (marked == 1) {
                EXPECT_LT(list.size, all.size + all.size / 8) << "most is let alone";
            }
            for (std::uint32_t k = 0; k < list.size; ++k) {
                PairShape shape;
                shape_pairs(scene.positions.data(), k < list.vertex_triangle, {&list.pairs[k], 1}, &shape);
                ASSERT_EQ(shape.normal.w, list.shapes[k].normal.w) << "shapes have gone with their pairs";
            }
        }
        std::vector<std::uint8_t> every(scene.positions.size(), 1);
        LaidOut<PairList> full(all.size - 1);
        finder.find_more(parallel, scene.bodies, scene.positions, scene.motions, every, full);
        EXPECT_TRUE(full.overflowed);
        EXPECT_EQ(full.size, 0u);
    }
}

}  // namespace
}  // namespace weft::test
