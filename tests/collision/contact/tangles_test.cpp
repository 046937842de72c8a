#include "collision/contact/crossings/tangles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "collision/contact/pairs/pair_finder.h"
#include "tests/collision/contact/contact_reference.h"
#include "tests/laid_out.h"

namespace weft::test {
namespace {

constexpr float edge_length = 0.01f, frame = 1.0f / 60;

std::vector<Vec4> lying(std::uint32_t side) {
    return grid_positions(side, side, [](float u, float v) {
        return Vec4{edge_length * u, 0, edge_length * v, 1};
    });
}

/// Upright, its lower border `depth` below the other sheet; turned, lest its vertices be over the other's.
std::vector<Vec4> standing(std::uint32_t rows, std::uint32_t columns, float depth) {
    return grid_positions(rows, columns, [&](float u, float v) {
        const float along = edge_length * (u - 0.5f * float(columns - 1));
        return Vec4{0.0971f + 0.9f * along, edge_length * v - depth, 0.1013f + 0.436f * along, 1};
    });
}

/// One sheet lies; another, narrower, stands in it.
ContactScene sheets(float depth, std::uint32_t columns = 8) {
    ContactScene scene;
    scene.add(lying(21), lying(21), grid_triangles(21, 21), 0.003f);
    scene.add(standing(9, columns, depth), standing(9, columns, depth), grid_triangles(9, columns), 0.003f);
    return scene;
}

/// One sheet lies; the peak of a dome comes through it by `depth`.
ContactScene dome(float depth) {
    ContactScene scene;
    scene.add(lying(21), lying(21), grid_triangles(21, 21), 0.003f);
    const std::vector<Vec4> over = grid_positions(15, 15, [&](float u, float v) {
        const float x = edge_length * (u - 7) + 0.0003f, z = edge_length * (v - 7) + 0.0004f;
        return Vec4{0.0971f + 0.9f * x - 0.436f * z, depth - 8 * (x * x + z * z),
                    0.1013f + 0.436f * x + 0.9f * z, 1};
    });
    scene.add(over, over, grid_triangles(15, 15), 0.003f);
    return scene;
}

/// What a substep knows of what crosses.
struct Found {
    explicit Found(const ContactScene& scene, std::size_t room = 1 << 12, int threads = 1)
        : parallel(threads), list(room), pairs(1 << 15), exempt(1 << 15), memory(scene.positions.size()) {
        finder.reserve(scene.bodies, room_for_pairs);
        tangles.reserve(Tangles::Room{.bodies = scene.bodies.size(),
                                      .particles = scene.positions.size(),
                                      .pairs = pairs.capacity(),
                                      .crossings = room});
        find(scene);
    }
    void find(const ContactScene& scene) {
        finder.find_crossings(parallel, scene.bodies, scene.positions, list);
        finder.find(parallel, scene.bodies, scene.positions, scene.motions, pairs);
        tangles.find({scene.bodies, scene.positions, pairs, frame}, list, memory);
        tangles.exempt(parallel, pairs, exempt);
    }
    [[nodiscard]] std::uint32_t exempt_pairs() const {
        std::uint32_t count = 0;
        for (std::uint32_t k = 0; k < pairs.size; ++k) count += exempt[k];
        return count;
    }

    Parallel parallel;
    LaidOut<PairFinder> finder;
    LaidOut<CrossingList> list;
    LaidOut<Tangles> tangles;
    LaidOut<PairList> pairs;
    std::vector<std::uint8_t> exempt;
    std::vector<TangleMemory> memory;
};

/// Each particle goes by the sum of what its rows wish for, of which the greatest goes so far.
void follow(const Tangles& tangles, ContactScene& scene, float step) {
    std::map<std::uint32_t, Vector3> ways;
    for (const UntanglingRow& row : tangles.rows())
        for (std::size_t c = 0; c < 5; ++c)
            ways.try_emplace(row.corners[c], Vector3::Zero()).first->second +=
                row.weights[c] * xyz(row.direction);
    float most = 0;
    for (const auto& [i, way] : ways) most = std::max(most, way.norm());
    for (const auto& [i, way] : ways) {
        Vec4& x = scene.positions[i];
        set_xyz(x, xyz(x) + step / most * way);
    }
}

TEST(Tangles, WhatDoesNotCrossIsLetBe) {
    const ContactScene scene = sheets(-0.002f);
    const Found found(scene);
    ASSERT_GT(found.pairs.size, 0u);
    EXPECT_FALSE(found.tangles.any());
    EXPECT_EQ(found.exempt_pairs(), 0u);
    EXPECT_EQ(found.tangles.counts().contours, 0u);
    EXPECT_TRUE(found.tangles.rows().empty());
    for (const TangleMemory& m : found.memory) EXPECT_EQ(m.steps, 0u);
}

TEST(Tangles, TwoSheetsCrossAlongOneContourOfTwoSides) {
    const ContactScene scene = sheets(0.013f);
    Found found(scene);
    ASSERT_GT(found.list.size, 10u);
    EXPECT_EQ(found.tangles.counts().contours, 1u);
    EXPECT_EQ(found.tangles.counts().crossings, found.list.size);

    LaidOut<Contours> contours;
    contours.reserve(scene.bodies.size(), found.list.size);
    contours.trace(scene.bodies, found.list.crossings.span().first(found.list.size));
    const auto body = [&](std::uint32_t k) { return body_of(scene.bodies, found.list.crossings[k].edge[0]); };
    for (std::uint32_t k = 0; k < found.list.size; ++k)
        EXPECT_EQ(contours.side_of_edge(k) == contours.side_of_edge(0), body(k) == body(0)) << k;
}

TEST(Tangles, SheetsThatCrossApartHaveContoursOfTheirOwn) {
    ContactScene scene;
    scene.add(lying(21), lying(21), grid_triangles(21, 21), 0.003f);
    for (int k = 0; k < 3; ++k) {
        std::vector<Vec4> strip = standing(9, 5, 0.013f);
        for (Vec4& p : strip) p.z += 0.05f * float(k - 1);
        scene.add(strip, strip, grid_triangles(9, 5), 0.003f);
    }
    EXPECT_EQ(Found(scene).tangles.counts().contours, 3u);
}

TEST(Tangles, RowsAddUpToNothingAndPointTheWayOut) {
    const ContactScene scene = dome(0.006f);
    const Found found(scene);
    ASSERT_GT(found.list.size, 10u);
    float up = 0;
    ASSERT_EQ(found.tangles.rows().size(), found.list.size);
    for (const UntanglingRow& row : found.tangles.rows()) {
        float sum = 0, on_edge = 0;
        Vector3 gap = Vector3::Zero();
        for (std::size_t c = 0; c < 5; ++c) {
            sum += row.weights[c];
            on_edge += c < 2 ? row.weights[c] : 0;
            gap += row.weights[c] * xyz(scene.positions[row.corners[c]]);
        }
        EXPECT_NEAR(sum, 0, 1e-6f);
        EXPECT_NEAR(on_edge, 1, 1e-6f);
        EXPECT_LT(gap.norm(), 1e-6f);
        EXPECT_NEAR(xyz(row.direction).norm(), 1, 1e-5f);
        EXPECT_NEAR(row.direction.w, 0.25f * edge_length, 0.25f * edge_length);
        up += row.corners[0] >= scene.bodies[1].first ? row.direction.y : -row.direction.y;
    }
    EXPECT_LT(up, -0.5f * float(found.list.size)) << "of the dome, against the sheet";
}

TEST(Tangles, WhoFollowsRowsComesFree) {
    for (const float depth : {0.002f, 0.006f, 0.012f}) {
        ContactScene scene = dome(depth);
        Found found(scene);
        int steps = 0;
        for (; found.list.size > 0 && steps < 200; ++steps) {
            follow(found.tangles, scene, 0.1f * edge_length);
            found.find(scene);
        }
        EXPECT_EQ(found.list.size, 0u) << depth;
    }
}

TEST(Tangles, PairsNearACommonContourAreExempt) {
    const ContactScene scene = sheets(0.013f, 12);
    const Found found(scene);
    const auto features_cross = [&](const FeaturePair& pair, std::uint32_t of_a) {
        for (const Crossing& c : found.list.crossings.span().first(found.list.size)) {
            const std::set<std::uint32_t> on_edge(c.edge.begin(), c.edge.end());
            const std::set<std::uint32_t> on_triangle(c.triangle.begin(), c.triangle.end());
            for (std::uint32_t a = 0; a < of_a; ++a)
                for (std::uint32_t b = of_a; b < 4; ++b)
                    if ((on_edge.contains(pair.corners[a]) && on_triangle.contains(pair.corners[b])) ||
                        (on_edge.contains(pair.corners[b]) && on_triangle.contains(pair.corners[a])))
                        return true;
        }
        return false;
    };
    std::uint32_t crossing = 0;
    for (std::uint32_t k = 0; k < found.pairs.size; ++k) {
        if (!features_cross(found.pairs.pairs[k], found.pairs.corners_of_a(k))) continue;
        ++crossing;
        EXPECT_EQ(found.exempt[k], 1);
    }
    EXPECT_GT(crossing, 10u);
}

TEST(Tangles, PairsFarFromItAreNot) {
    ContactScene scene = sheets(0.013f, 5);
    std::vector<Vec4> cover = lying(4);
    for (Vec4& p : cover) p = {p.x + 0.001f, 0.002f, p.z + 0.0013f, 1};
    scene.add(cover, cover, grid_triangles(4, 4), 0.003f);
    const Found found(scene);
    std::uint32_t of_cover = 0;
    for (std::uint32_t k = 0; k < found.pairs.size; ++k) {
        if (found.pairs.pairs[k].corners[0] < scene.bodies[2].first &&
            found.pairs.pairs[k].corners[3] < scene.bodies[2].first)
            continue;
        ++of_cover;
        EXPECT_EQ(found.exempt[k], 0);
    }
    EXPECT_GT(of_cover, 10u);
    EXPECT_GT(found.exempt_pairs(), 10u);
}

TEST(Tangles, AreRememberedForTwoCleanSteps) {
    ContactScene scene = sheets(0.002f);
    Found found(scene);
    ASSERT_TRUE(found.tangles.any());
    const ContactScene apart = sheets(-0.001f);
    for (int k = 0; k < 2; ++k) {
        found.find(apart);
        EXPECT_EQ(found.list.size, 0u);
        EXPECT_TRUE(found.tangles.any());
        EXPECT_GT(found.exempt_pairs(), 0u);
    }
    found.find(apart);
    EXPECT_FALSE(found.tangles.any());
    EXPECT_EQ(found.exempt_pairs(), 0u);
    for (const TangleMemory& m : found.memory) EXPECT_EQ(m.name, 0u);
}

TEST(Tangles, AreRecalledWithoutASearch) {
    const ContactScene scene = sheets(0.013f);
    Found found(scene);
    const std::vector<TangleMemory> before = found.memory;
    found.tangles.clear();
    EXPECT_FALSE(found.tangles.any());
    found.tangles.recall(scene.bodies, found.memory);
    EXPECT_TRUE(found.tangles.any());
    const std::vector<std::uint8_t> all = found.exempt;
    found.tangles.exempt(found.parallel, found.pairs, found.exempt);
    EXPECT_EQ(found.exempt, all);
    EXPECT_EQ(std::memcmp(found.memory.data(), before.data(), before.size() * sizeof(TangleMemory)), 0);
}

TEST(Tangles, WhatGetsNoShorterGoesWhereVotesSayForASecond) {
    const ContactScene scene = sheets(0.013f);
    Found found(scene);
    for (int k = 0; k < 19; ++k) found.find(scene);
    for (const TangleMemory& m : found.memory) EXPECT_EQ(m.votes, 0u);
    for (int k = 0; k < 55; ++k) found.find(scene);
    EXPECT_EQ(found.memory[found.list.crossings[0].edge[0]].votes, 1u);
    EXPECT_EQ(found.tangles.counts().stalled, 0u);
    EXPECT_GT(found.tangles.rows().front().direction.w, 0);
    for (int k = 0; k < 10; ++k) found.find(scene);
    EXPECT_EQ(found.tangles.counts().stalled, 1u);
    EXPECT_EQ(found.tangles.rows().front().direction.w, 0);
    EXPECT_GT(found.exempt_pairs(), 10u);
    ContactScene helped = scene;
    for (std::uint32_t i = helped.bodies[1].first; i < helped.positions.size(); ++i)
        if ((i - helped.bodies[1].first) % 8 > 4) helped.positions[i].y += 0.1f;
    found.find(helped);
    EXPECT_EQ(found.tangles.counts().stalled, 0u);
}

TEST(Tangles, DoNotDependOnThreadsAndEndWhereRoomDoes) {
    ContactScene scene = sheets(0.013f);
    scene.jitter(0.004f);
    const Found all(scene);
    ASSERT_GT(all.list.size, 30u);
    for (const std::size_t room : {std::size_t{0}, std::size_t{1}, std::size_t{20}, std::size_t{4096}}) {
        for (const int threads : {1, 4}) {
            const Found found(scene, room, threads), again(scene, room);
            EXPECT_EQ(found.tangles.rows().size(), std::min<std::size_t>(room, all.list.size));
            EXPECT_EQ(found.exempt, again.exempt);
            if (room > all.list.size) {
                EXPECT_EQ(found.exempt, all.exempt);
            }
            EXPECT_EQ(found.tangles.any(), room > 0);
        }
    }
}

}  // namespace
}  // namespace weft::test
