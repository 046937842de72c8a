#include "collision/contact/pairs/pair_finder.h"

#include <gtest/gtest.h>

#include <deque>
#include <map>
#include <numeric>
#include <set>

#include "tests/collision/contact/pair_list_reference.h"
#include "tests/laid_out.h"
#include "tests/targets/targets.h"

namespace weft::test {
namespace {

TEST(PairFinder, CalmSheetHasNoPairs) {
    EXPECT_EQ(pairs_of(waving(30, 0)).size, 0u);
    EXPECT_EQ(pairs_of(waving(30, 1)).size, 0u);
}

TEST(PairFinder, WavingSheetsAsReference) {
    for (const float height : {0.0f, 1.0f, 3.0f, 20.0f}) {
        ContactScene scene = waving(21, height);
        expect_same_pairs(scene);
        scene.jitter(0.2f * edge);
        scene.bodies[0].reach = 0.6f * edge;
        expect_same_pairs(scene);
    }
}

TEST(PairFinder, FoldedSheetsAsReference) {
    for (const float gap : {0.1f, 0.3f, 1.0f}) expect_same_pairs(folded(24, gap), gap < 0.5f ? 100 : 0);
}

TEST(PairFinder, MovingSheetsAsReference) {
    for (const float size : {0.1f, 1.0f, 5.0f}) {
        ContactScene scene = folded(20, 0.5f);
        scene.add_motions(random_vectors(scene.positions.size(), size * edge, 7));
        expect_same_pairs(scene, 10);
    }
    ContactScene falling = waving(17, 1);
    for (Vec4& m : falling.motions) m = {0.003f, -0.05f, 0.001f, 0};
    expect_same_pairs(falling);
}

/// Rest shapes that are not one piece with a convex border, or lie over themselves, laid so that what touches
/// is not near in the mesh.
TEST(PairFinder, SheetsWithHolesSlitsAndFoldsAtRestAsReference) {
    constexpr std::uint32_t side = 16;
    const std::vector<Triangle> all = grid_triangles(side, side);
    const auto without = [&](const auto& leaves_out) {
        std::vector<Triangle> triangles;
        for (const Triangle& t : all)
            if (!leaves_out(*std::ranges::min_element(t) % side, *std::ranges::min_element(t) / side))
                triangles.push_back(t);
        return triangles;
    };
    std::vector<Vec4> doubled = flat(side, side), rolled = doubled;
    for (Vec4& p : doubled) p.x = std::min(p.x, 15 * edge - p.x);
    for (Vec4& p : rolled) {
        const float angle = 50 * p.x, radius = 0.02f + 0.0005f * angle;
        p = {radius * std::cos(angle), radius * std::sin(angle), p.z, 0};
    }
    const std::vector<std::pair<std::vector<Vec4>, std::vector<Triangle>>> rests = {
        {flat(side, side), without([](auto c, auto r) { return c > 4 && c < 9 && r > 4 && r < 9; })},
        {flat(side, side), without([](auto c, auto r) { return c == 7 && r < 12; })},
        {flat(side, side), without([](auto c, auto r) { return c > 7 && r > 7; })},
        {flat(side, side), without([](auto c, auto) { return c == 7; })},
        {doubled, all},
        {rolled, all}};
    for (const auto& [rest, triangles] : rests) {
        ContactScene at_rest;
        at_rest.add(rest, rest, triangles, 0.6f * edge);
        expect_same_pairs(at_rest);
        for (std::uint32_t seed = 1; seed <= 2; ++seed) {
            ContactScene scene;
            scene.add(rest, smoothly(rest, 0.4f, seed), triangles, 0.6f * edge);
            expect_same_pairs(scene);
        }
    }
    std::vector<Vec4> closed = flat(side, side);  // the slit's sides on one another
    for (Vec4& p : closed)
        if (p.x > 7.5f * edge) p.x -= 0.9f * edge;
    ContactScene scene;
    scene.add(rests[1].first, closed, rests[1].second, 0.3f * edge);
    expect_same_pairs(scene, 20);
}

TEST(PairFinder, MotionsOfMetresAsReference) {
    ContactScene scene = waving(12, 1);
    scene.add_motions(random_vectors(scene.positions.size(), 3, 3));
    expect_same_pairs(scene, 1000);
}

TEST(PairFinder, RandomTrianglesAsReference) {
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        const std::vector<Vec4> points = random_vectors(150, 1, seed);
        std::mt19937 random(seed);
        std::vector<Triangle> triangles(120);
        for (Triangle& t : triangles)
            for (std::uint32_t& i : t) i = std::uint32_t(random() % points.size());
        ContactScene scene;
        scene.add(points, points, triangles, 0.05f);
        expect_same_pairs(scene, 100);
        scene.add_motions(random_vectors(points.size(), 0.1f, seed + 10));
        expect_same_pairs(scene, 100);
    }
}

TEST(PairFinder, ClustersAsReference) {
    ContactScene scene = waving(16, 0);
    const std::vector<Vec4> near = random_vectors(scene.positions.size(), edge, 5);
    for (std::size_t i = 0; i < near.size(); ++i) {
        const float at = i % 3 == 0 ? 0.5f : 0.0f;
        scene.positions[i] = {at + near[i].x, near[i].y, near[i].z, 0};
    }
    expect_same_pairs(scene, 1000);
}

TEST(PairFinder, IrregularMeshesAsReference) {
    constexpr std::uint32_t side = 18;
    std::vector<std::uint32_t> renumbered(side * side);
    std::iota(renumbered.begin(), renumbered.end(), 0u);
    std::shuffle(renumbered.begin(), renumbered.end(), std::mt19937(3));
    std::vector<Triangle> triangles = grid_triangles(side, side);
    for (Triangle& t : triangles)
        for (std::uint32_t& i : t) i = renumbered[i];
    const ContactScene straight = folded(side, 0.3f);
    const std::vector<Vec4> rest = flat(side, side);
    std::vector<Vec4> now(rest.size()), at_rest(rest.size());
    for (std::size_t i = 0; i < now.size(); ++i) {
        now[renumbered[i]] = straight.positions[i];
        at_rest[renumbered[i]] = rest[i];
    }
    ContactScene scene;
    scene.add(at_rest, now, triangles, 0.3f * edge);
    scene.jitter(0.3f * edge);
    expect_same_pairs(scene, 100);
}

TEST(PairFinder, AFanOfVeryManyTrianglesAsReference) {
    std::vector<Vec4> points = {{0, 0, 0, 0}};
    std::vector<Triangle> triangles;
    for (std::uint32_t k = 0; k < 200; ++k) {
        const float angle = 0.0314159265f * float(k);
        points.push_back({std::cos(angle), 0.1f * std::sin(9 * angle), std::sin(angle), 0});
        triangles.push_back({0, 1 + k, 1 + (k + 1) % 200});
    }
    ContactScene scene;
    scene.add(points, points, triangles, 0.05f);
    expect_same_pairs(scene, 100);
}

TEST(PairFinder, CoincidentLayersAsReference) {
    ContactScene scene;
    const std::vector<Vec4> rest = flat(10, 10);
    scene.add(rest, rest, grid_triangles(10, 10), 0.3f * edge);
    scene.add(rest, rest, grid_triangles(10, 10), 0.3f * edge);  // exactly on the first
    std::vector<Vec4> shifted = rest;
    for (Vec4& p : shifted) p.x += 0.37f * edge;
    scene.add(rest, shifted, grid_triangles(10, 10), 0.3f * edge);
    expect_same_pairs(scene, 1000);
    // What touches has distance 0 to rounding, is listed, and has a normal across.
    const LaidOut<PairList> list = pairs_of(scene);
    std::map<Corners, std::uint32_t> listed[2];
    for (std::uint32_t k = 0; k < list.size; ++k) {
        const bool vt = k < list.vertex_triangle;
        listed[vt].emplace(key_of(list.pairs[k].corners, vt), k);
        EXPECT_NEAR(in_double(list.shapes[k].normal).norm(), 1, 1e-5);
        EXPECT_GT(list.shapes[k].normal.w, -1e-6f * edge);
    }
    std::size_t missed = 0;
    for_each_pair(scene, [&](const Corners& c, std::size_t of_a, double reach) {
        const ReferencePair pair = reference_pair(c, of_a, scene.positions, scene.motions);
        missed += pair.distance < 0.9 * reach && !listed[of_a == 1].contains(key_of(c, of_a == 1));
    });
    EXPECT_EQ(missed, 0u);
}

TEST(PairFinder, FarFromTheOriginAsReference) {
    ContactScene scene = folded(20, 0.3f);
    scene.add_motions(random_vectors(scene.positions.size(), 0.2f * edge, 5));
    for (Vec4& p : scene.positions) p = {p.x + 1000, p.y - 700, p.z + 500, 0};
    expect_same_pairs(scene, 100);
}

TEST(PairFinder, BodiesMeetAsTheirMasksSayAtTheMeanOfTheirReach) {
    ContactScene scene;
    const std::vector<Vec4> rest = flat(9, 9);
    for (std::uint32_t k = 0; k < 4; ++k) {
        std::vector<Vec4> now = rest;
        for (Vec4& p : now) p.y += 0.1f * edge * float(k);
        now.insert(now.begin(), 3, Vec4{0.03f, 0.0001f * float(k), 0.02f, 0});  // loose particles
        std::vector<Vec4> at_rest(3);
        at_rest.insert(at_rest.end(), rest.begin(), rest.end());
        scene.add(at_rest, now, grid_triangles(9, 9, 3), edge * (0.1f + 0.1f * float(k)));
    }
    scene.jitter(0.03f * edge);
    expect_same_pairs(scene, 1000);
    scene.bodies[0].layer = 2;
    scene.bodies[1].mask = 2;
    scene.bodies[2].meets_itself = false;
    scene.bodies[3].mask = ~2u;
    expect_same_pairs(scene, 500);
}

TEST(PairFinder, LooseParticlesAndEmptyMeshesListNothing) {
    ContactScene scene;
    scene.add({}, {}, {}, 1);
    const std::vector<Vec4> points = random_vectors(100, 0.001f, 1);
    scene.add(points, points, {}, 1);
    scene.add(points, points, {{1, 1, 2}, {3, 3, 3}}, 1);
    EXPECT_EQ(pairs_of(scene).size, 0u);
    EXPECT_EQ(pairs_of(ContactScene()).size, 0u);
}

/// A finder searches now these bodies, now those, in the memory of the largest: what it found before, where
/// bodies had more patches or lay elsewhere, is forgotten.
TEST(PairFinder, FindsTheSameWhateverItSearchedBefore) {
    std::deque<ContactScene> scenes;  // where they are made they stay: bodies point to their meshes
    for (const std::uint32_t side : {40u, 9u, 24u, 12u, 40u}) scenes.push_back(folded(side, 0.3f));
    LaidOut<PairFinder> finder;
    Parallel parallel(1);
    for (const ContactScene& scene : scenes) {
        finder.reserve(scene.bodies, room_for_pairs);
        LaidOut<PairList> list(1 << 18);
        finder.find(parallel, scene.bodies, scene.positions, scene.motions, list);
        const LaidOut<PairList> expected = pairs_of(scene);
        ASSERT_EQ(list.size, expected.size);
        for (std::uint32_t k = 0; k < list.size; ++k)
            EXPECT_EQ(list.pairs[k].corners, expected.pairs[k].corners);
    }
}

TEST(PairFinder, WhatIsNotFiniteListsNothing) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                    inf = std::numeric_limits<float>::infinity(), most = std::numeric_limits<float>::max();
    ContactScene scene = folded(20, 0.3f);
    ContactScene spoilt = scene;
    std::set<std::uint32_t> bad;
    const auto spoil = [&](std::uint32_t i, std::vector<Vec4>& values, const Vec4& value) {
        values[i] = value;
        bad.insert(i);
    };
    spoil(17, spoilt.positions, {nan, 0, 0, 0});
    spoil(45, spoilt.positions, {0, -inf, 0, 0});
    spoil(46, spoilt.positions, {0, 0, inf, nan});
    spoil(99, spoilt.motions, {0, nan, 0, 0});
    spoil(130, spoilt.motions, {inf, 0, 0, 0});
    spoilt.positions[200].w = nan;
    const LaidOut<PairList> all = pairs_of(scene), some = pairs_of(spoilt);
    std::set<Corners> expected[2], found[2];
    for (std::uint32_t k = 0; k < all.size; ++k) {
        const Corners& c = all.pairs[k].corners;
        if (std::ranges::none_of(c, [&](std::uint32_t i) { return bad.contains(i); }))
            expected[k < all.vertex_triangle].insert(key_of(c, k < all.vertex_triangle));
    }
    for (std::uint32_t k = 0; k < some.size; ++k)
        found[k < some.vertex_triangle].insert(key_of(some.pairs[k].corners, k < some.vertex_triangle));
    EXPECT_EQ(found[0], expected[0]);
    EXPECT_EQ(found[1], expected[1]);

    for (std::size_t i = 0; i < spoilt.positions.size(); i += 2) spoilt.positions[i] = {most, -most, most, 0};
    for (std::size_t i = 0; i < spoilt.positions.size(); i += 4) spoilt.motions[i] = {most, most, -most, 0};
    pairs_of(spoilt);  // returns
    for (Vec4& p : spoilt.positions) p = {nan, nan, nan, nan};
    EXPECT_EQ(pairs_of(spoilt).size, 0u);
}

TEST(PairFinder, AsReferenceOnEveryVectorTarget) {
    ContactScene scene = folded(20, 0.3f);
    scene.add_motions(random_vectors(scene.positions.size(), 0.2f * edge, 7));
    for (const std::int64_t target : vector_targets()) {
        use_target(target);
        expect_same_pairs(scene, 100);
    }
    use_target(0);
}

}  // namespace
}  // namespace weft::test
