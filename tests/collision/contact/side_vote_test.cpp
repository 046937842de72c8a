#include "collision/contact/crossings/side_vote.h"

#include <gtest/gtest.h>

#include <cmath>

#include "collision/contact/pairs/pair_finder.h"
#include "tests/collision/contact/contact_reference.h"
#include "tests/laid_out.h"

namespace weft::test {
namespace {

constexpr float edge = 0.01f, reach = 0.003f;
constexpr std::uint32_t side = 21;

std::vector<Vec4> level(float height) {
    return grid_positions(side, side, [&](float u, float v) { return Vec4{edge * u, height, edge * v, 1}; });
}

/// A bit turned; over the height 0 but for this part of it, which is under.
std::vector<Vec4> tilted(float part) {
    return grid_positions(side, side, [&](float u, float v) {
        const float x = u - part * float(side - 1);
        return Vec4{edge * (u + 0.06f * v) + 0.0003f, 0.0015f * std::tanh(0.8f * (x + 0.03f * v)),
                    edge * (v - 0.06f * u) + 0.0007f, 1};
    });
}

std::vector<Triangle> wound(bool the_other_way) {
    std::vector<Triangle> triangles = grid_triangles(side, side);
    if (the_other_way)
        for (auto& [a, b, c] : triangles) std::swap(b, c);
    return triangles;
}

ContactScene crossed(float part, bool flip_lower = false, bool flip_upper = false) {
    ContactScene scene;
    scene.add(level(0), level(0), wound(flip_lower), reach);
    scene.add(tilted(part), tilted(part), wound(flip_upper), reach);
    return scene;
}

/// The vote on the only contour.
struct Vote {
    explicit Vote(const ContactScene& scene) : list(1 << 12), pairs(1 << 15) {
        const std::size_t particles = scene.positions.size();
        finder.reserve(scene.bodies, room_for_pairs);
        finder.find_crossings(serial, scene.bodies, scene.positions, list);
        finder.find(serial, scene.bodies, scene.positions, scene.motions, pairs);
        contours.reserve(scene.bodies.size(), list.capacity());
        contours.trace(scene.bodies, crossings());
        votes.reserve(particles, pairs.capacity());
        votes.begin(scene.bodies, scene.positions, pairs);
        result = votes.of(0, crossings(), contours);
    }
    [[nodiscard]] std::span<const Crossing> crossings() const {
        return list.crossings.span().first(list.size);
    }
    /// The mean of the ways that the second body is told to go, against the first.
    [[nodiscard]] Vector3 way_of_second(const ContactScene& scene) const {
        Vector3 sum = Vector3::Zero();
        for (std::uint32_t k = 0; k < list.size; ++k) {
            const Crossing& crossing = crossings()[k];
            const Vector3 way = votes.way_of(crossing, contours.side_of_edge(k), result.side);
            EXPECT_NEAR(way.norm(), 1, 1e-5f);
            sum += crossing.edge[0] >= scene.bodies[1].first ? way : Vector3(-way);
        }
        return sum / float(list.size);
    }

    Parallel serial{1};
    LaidOut<PairFinder> finder;
    LaidOut<CrossingList> list;
    LaidOut<PairList> pairs;
    LaidOut<Contours> contours;
    LaidOut<SideVote> votes;
    SideVote::Result result;
};

TEST(SideVote, TheSmallerPartHasToGoHoweverTrianglesAreWound) {
    for (const int wound : {0, 1, 2, 3}) {
        for (const float part : {0.1f, 0.2f, 0.42f, 0.58f, 0.8f}) {
            const ContactScene scene = crossed(part, (wound & 1) != 0, (wound & 2) != 0);
            const Vote vote(scene);
            ASSERT_GT(vote.list.size, 15u);
            ASSERT_EQ(vote.contours.size(), 1u);
            ASSERT_NE(vote.result.side, 0);
            const Vector3 way = vote.way_of_second(scene);
            if (part < 0.5f) {
                EXPECT_GT(way.y(), 0.9f) << part << ", wound " << wound;
            } else {
                EXPECT_LT(way.y(), -0.9f) << part << ", wound " << wound;
            }
        }
    }
}

TEST(SideVote, TheMinorityIsAsLargeAsItsPart) {
    std::uint32_t before = 0;
    for (const float part : {0.1f, 0.2f, 0.3f, 0.42f}) {
        const Vote vote(crossed(part));
        EXPECT_GT(vote.result.minority, before) << part;
        const float all = float(vote.pairs.vertex_triangle);
        EXPECT_NEAR(float(vote.result.minority) / all, part, 0.15f);
        before = vote.result.minority;
    }
}

TEST(SideVote, LayersThatDoNotCrossHaveNoPart) {
    const ContactScene two = crossed(0.3f);
    ContactScene three = crossed(0.3f);
    three.add(level(-0.0035f), level(-0.0035f), wound(false), reach);
    const Vote of_two(two), of_three(three);
    EXPECT_GT(of_three.pairs.vertex_triangle, of_two.pairs.vertex_triangle + 100);
    EXPECT_EQ(of_three.result.side, of_two.result.side);
    EXPECT_EQ(of_three.result.minority, of_two.result.minority);
}

TEST(SideVote, NothingNearIsNoVote) {
    ContactScene scene = crossed(0.3f);
    for (ContactBody& body : scene.bodies) body.reach = 1e-6f;
    Vote vote(scene);
    EXPECT_EQ(vote.result.side, 0);
    EXPECT_EQ(vote.result.minority, 0u);
}

TEST(SideVote, LeavesNothingBehindForTheNext) {
    const ContactScene scene = crossed(0.3f);
    Vote vote(scene);
    const SideVote::Result again = vote.votes.of(0, vote.crossings(), vote.contours);
    EXPECT_EQ(again.side, vote.result.side);
    EXPECT_EQ(again.minority, vote.result.minority);
}

// A step took minutes where each of hundreds of contours reached all over crumpled cloth.
TEST(SideVote, ManyInOneStepReachNoFartherThanOneMay) {
    const ContactScene scene = crossed(0.3f);
    Vote vote(scene);
    for (int k = 0; k < 3; ++k) (void)vote.votes.of(0, vote.crossings(), vote.contours);
    const SideVote::Result near = vote.votes.of(0, vote.crossings(), vote.contours);
    EXPECT_GT(near.minority, 0u);
    EXPECT_LT(near.minority, vote.result.minority / 2);
    vote.votes.begin(scene.bodies, scene.positions, vote.pairs);
    EXPECT_EQ(vote.votes.of(0, vote.crossings(), vote.contours).minority, vote.result.minority);
}

TEST(Contours, ListTheirCrossingsInOrder) {
    ContactScene scene = crossed(0.3f);
    scene.add(level(0.001f), level(0.001f), wound(false), reach);
    const Vote vote(scene);
    ASSERT_GT(vote.contours.size(), 1u);
    std::uint32_t count = 0;
    for (std::uint32_t contour = 0; contour < vote.contours.size(); ++contour) {
        std::uint32_t least = 0;
        vote.contours.for_each_crossing(contour, [&](std::uint32_t k) {
            EXPECT_EQ(vote.contours.contour_of(k), contour);
            EXPECT_GE(k, least);
            least = k + 1;
            ++count;
        });
    }
    EXPECT_EQ(count, vote.list.size);
}

}  // namespace
}  // namespace weft::test
