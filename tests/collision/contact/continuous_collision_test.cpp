// Detection and settling against an exact oracle for continuous collision: what collides on its way is
// listed, and after it was settled nothing does.

#include "tests/collision/contact/continuous_collision.h"

#include <gtest/gtest.h>

#include <set>

#include "collision/contact/response/settle.h"
#include "tests/collision/contact/pair_finder_scenes.h"
#include "tests/laid_out.h"

namespace weft::test {
namespace {

MovingPair vertex_through_triangle(double height, double from, double to) {
    return {{Point(0.2, from, 0.2), Point(0, height, 0), Point(1, height, 0), Point(0, height, 1)},
            {Point(0.2, to, 0.2), Point(0, height, 0), Point(1, height, 0), Point(0, height, 1)},
            1};
}

TEST(CollisionOracle, KnowsWhatItIsToldByHand) {
    EXPECT_TRUE(collides(vertex_through_triangle(0, 1, -1)));
    EXPECT_TRUE(collides(vertex_through_triangle(0, 1, 0)));
    EXPECT_FALSE(collides(vertex_through_triangle(0, 1, 1e-6)));
    MovingPair beside = vertex_through_triangle(0, 1, -1);
    for (auto* corners : {&beside.start, &beside.end}) (*corners)[0].x() = 0.8001;
    EXPECT_FALSE(collides(beside));
    MovingPair edges{{Point(-1, 0, 0), Point(1, 0, 0), Point(0, 1, -1), Point(0, 1, 1)},
                     {Point(-1, 0, 0), Point(1, 0, 0), Point(0, -1, -1), Point(0, -1, 1)},
                     2};
    EXPECT_TRUE(collides(edges));
    edges.end[2].x() = edges.end[3].x() = 2.0001;  // past the end of the first when it is as high
    EXPECT_FALSE(collides(edges));
    edges.end[2].x() = edges.end[3].x() = 1.9999;
    EXPECT_TRUE(collides(edges));
}

TEST(CollisionOracle, SeesWhatHasCrossedAtTheEnd) {
    const Triangles mesh = triangle_soup(40, 0.5f, 11);
    const Points start = points(mesh.positions);
    const Points end = points(ends_of(mesh.positions, random_vectors(mesh.size(), 0.3f, 12)));
    ASSERT_GT(crossings(mesh, end), 0);
    const LaidOut<PairList> pairs = all_pairs(mesh);
    int colliding = 0;
    for (std::uint32_t k = 0; k < pairs.size; ++k)
        colliding += collides(moving_pair(pairs.pairs[k], pairs.corners_of_a(k), start, end));
    EXPECT_GT(colliding, 0);
    // An edge that is through a triangle came there through its face or over its border.
    for (const auto& [p, q] : mesh.edges())
        for (const auto& t : mesh.triangles) {
            const std::set<std::uint32_t> all = {p, q, t[0], t[1], t[2]};
            if (all.size() < 5 || !cuts(end[p], end[q], end[t[0]], end[t[1]], end[t[2]])) continue;
            bool any = false;
            for (const std::uint32_t v : {p, q})
                any |= collides(moving_pair({{v, t[0], t[1], t[2]}}, 1, start, end));
            for (std::size_t k = 0; k < 3; ++k)
                any |= collides(moving_pair({{p, q, t[k], t[(k + 1) % 3]}}, 2, start, end));
            EXPECT_TRUE(any);
        }
}

std::set<std::array<std::uint32_t, 4>> listed(const PairList& list, std::uint32_t of_a) {
    std::set<std::array<std::uint32_t, 4>> keys;
    for (std::uint32_t k = 0; k < list.size; ++k) {
        std::array<std::uint32_t, 4> c = list.pairs[k].corners;
        if (list.corners_of_a(k) != of_a) continue;
        std::sort(c.begin() + (of_a == 1 ? 1 : 0), c.begin() + (of_a == 1 ? 4 : 2));
        if (of_a == 2) {
            std::sort(c.begin() + 2, c.end());
            if (c[2] < c[0]) c = {c[2], c[3], c[0], c[1]};
        }
        keys.insert(c);
    }
    return keys;
}

TEST(PairFinder, ListsEveryPairThatCollidesOnItsWay) {
    constexpr std::uint32_t side = 12;
    for (const float speed : {0.5f, 3.0f, 10.0f}) {
        ContactScene scene = folded(side, 0.3f);
        scene.add_motions(random_vectors(scene.positions.size(), speed * edge, 5));
        const LaidOut<PairList> list = pairs_of(scene, 1, 1 << 20);
        ASSERT_FALSE(list.overflowed);
        const std::set<std::array<std::uint32_t, 4>> of_kind[] = {listed(list, 1), listed(list, 2)};
        const Points start = points(scene.positions), end = points(ends_of(scene.positions, scene.motions));
        Triangles mesh{scene.positions, grid_triangles(side, side)};
        const LaidOut<PairList> all = all_pairs(mesh);
        int colliding = 0, missed = 0;
        for (std::uint32_t k = 0; k < all.size; ++k) {
            const std::uint32_t of_a = all.corners_of_a(k);
            if (!collides(moving_pair(all.pairs[k], of_a, start, end))) continue;
            LaidOut<PairList> one(1);
            one.pairs[0] = all.pairs[k];
            one.size = 1;
            one.vertex_triangle = of_a == 1 ? 1 : 0;
            ++colliding;
            missed += of_kind[of_a - 1].contains(*listed(one, of_a).begin()) ? 0 : 1;
        }
        EXPECT_GT(colliding, 50) << speed;
        EXPECT_EQ(missed, 0) << speed;
    }
}

/// Of pairs that collide on the straight ways, in the frame of the common motion.
int colliding_on_the_way(const Triangles& mesh, const PairList& pairs, std::span<const Vec4> ways,
                         std::span<const float> parts) {
    const Points start = points(mesh.positions);
    Points end = start;
    for (std::size_t i = 0; i < end.size(); ++i)
        end[i] += (parts.empty() ? 1.0 : double{parts[i]}) * point(ways[i]);
    int count = 0;
    for (std::uint32_t k = 0; k < pairs.size; ++k)
        count += collides(moving_pair(pairs.pairs[k], pairs.corners_of_a(k), start, end));
    return count;
}

TEST(Settle, NoPairCollidesOnItsWay) {
    for (unsigned seed = 0; seed < 4; ++seed) {
        const bool is_soup = seed < 2;
        const Triangles mesh =
            is_soup ? triangle_soup(40, 0.5f, seed) : folded_packet(4, 20, 5, 0.05f, 0.01f);
        const LaidOut<PairList> pairs = all_pairs(mesh);
        for (const float size : {0.03f, 0.5f}) {
            Rows wanted = random_vectors(mesh.size(), size, seed + 40);
            Parallel parallel(1);
            LaidOut<Settler> settler;
            settler.reserve(mesh.positions.size(), 1, pairs.size);
            const ParticleRange all{0, mesh.size()};
            const BodyGroup group{{&all, 1}, mesh.positions};
            settler.split(parallel, group, wanted);
            EXPECT_GT(colliding_on_the_way(mesh, pairs, settler.relative(), {}), 0);
            static_cast<void>(settler.settle(parallel, group, pairs, {}, {1e-4f, 30}, wanted));
            EXPECT_EQ(colliding_on_the_way(mesh, pairs, settler.relative(), settler.fractions()), 0)
                << seed << ' ' << size;
        }
    }
}

}  // namespace
}  // namespace weft::test
