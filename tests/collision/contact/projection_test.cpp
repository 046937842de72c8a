#include "collision/contact/response/projection.h"

#include <gtest/gtest.h>

#include <cstring>

#include "collision/contact/response/leverage.h"
#include "tests/collision/contact/settle_reference.h"
#include "tests/laid_out.h"

namespace weft::test {
namespace {

std::uint32_t project(const Rows& positions, const PairList& pairs, float wanted, std::uint32_t iterations,
                      Rows& displacements, std::span<const std::uint8_t> exempt = {}, int threads = 1) {
    Parallel parallel(threads);
    LaidOut<PairProjection> projection;
    projection.reserve(positions.size(), pairs.size);
    return projection.project(parallel, positions, pairs, exempt, {wanted, {}}, iterations, displacements);
}

/// A vertex over the middle of a triangle's edge: weights 1, and -1/2, -1/2, 0.
LaidOut<PairList> one_pair() {
    LaidOut<PairList> pairs(1);
    pairs.size = pairs.vertex_triangle = 1;
    pairs.pairs[0] = {{0, 1, 2, 3}};
    pairs.shapes[0] = {{1, -0.5f, -0.5f, 0}, {0, 1, 0, 0.1f}};
    return pairs;
}
Rows one_pairs_corners() {
    return {{0, 0.1f, 0, 1}, {-1, 0, 0, 3}, {1, 0, 0, 1}, {0, 0, 1, 1}};
}

TEST(PairProjection, OpensAGapToWhatIsWantedByInverseMass) {
    Rows displacements(4, Vec4{7, 0, 0, 5});
    displacements[0].y = -0.3f;
    EXPECT_EQ(project(one_pairs_corners(), one_pair(), 0.05f, 1, displacements), 1u);
    const float impulse = 0.25f / (1 + 0.75f + 0.25f);
    EXPECT_NEAR(displacements[0].y, -0.3f + impulse, 1e-6f);
    EXPECT_NEAR(displacements[1].y, -1.5f * impulse, 1e-6f);
    EXPECT_NEAR(displacements[2].y, -0.5f * impulse, 1e-6f);
    EXPECT_EQ(displacements[3].y, 0);
    for (const Vec4& d : displacements) {
        EXPECT_EQ(d.x, 7);
        EXPECT_EQ(d.w, 5);
    }
    EXPECT_EQ(project(one_pairs_corners(), one_pair(), 0.0499f, 1, displacements), 0u);
}

TEST(PairProjection, LeavesPinnedAndExemptAndUncertainAlone) {
    Rows start(4), positions = one_pairs_corners();
    start[0].y = -0.3f;
    Rows displacements = start;
    positions[0].w = 0;
    EXPECT_EQ(project(positions, one_pair(), 0.05f, 1, displacements), 1u);
    EXPECT_EQ(displacements[0].y, -0.3f);
    EXPECT_NEAR(0.5f * (displacements[1].y + displacements[2].y), -0.25f, 1e-6f);

    displacements = start;
    for (Vec4& x : positions) x.w = 0;
    EXPECT_EQ(project(positions, one_pair(), 0.05f, 1, displacements), 0u);
    EXPECT_EQ(displacements[0].y, -0.3f);

    const std::uint8_t exempt = 1;
    EXPECT_EQ(project(one_pairs_corners(), one_pair(), 0.05f, 1, displacements, {&exempt, 1}), 0u);
    LaidOut<PairList> uncertain = one_pair();
    uncertain.shapes[0].normal.w = 0;
    EXPECT_EQ(project(one_pairs_corners(), uncertain, 0.05f, 1, displacements), 0u);
    EXPECT_EQ(project(one_pairs_corners(), PairList(), 0.05f, 1, displacements), 0u);
}

TEST(PairProjection, APairsShareIsThatOfItsBusiestCorner) {
    // The second pair has corners 0 to 2 too, and a vertex of its own.
    LaidOut<PairList> pairs(2);
    pairs.size = pairs.vertex_triangle = 2;
    pairs.pairs[0] = {{0, 1, 2, 3}};
    pairs.pairs[1] = {{4, 1, 2, 3}};
    pairs.shapes[0] = pairs.shapes[1] = one_pair().shapes[0];
    Rows positions = one_pairs_corners(), displacements(5);
    positions.push_back({0, 0.1f, 0, 1});
    displacements[0].y = displacements[4].y = -0.3f;
    EXPECT_EQ(project(positions, pairs, 0.05f, 1, displacements), 2u);
    const float impulse = 0.5f * 0.25f / 2;
    EXPECT_NEAR(displacements[0].y, -0.3f + impulse, 1e-6f);
    EXPECT_NEAR(displacements[4].y, -0.3f + impulse, 1e-6f);
    EXPECT_NEAR(displacements[2].y, -0.5f * 2 * impulse, 1e-6f);

    // What is pinned takes no share, however busy.
    for (std::size_t i = 1; i < 4; ++i) positions[i].w = 0;
    displacements.assign(5, {});
    displacements[0].y = displacements[4].y = -0.3f;
    project(positions, pairs, 0.05f, 1, displacements);
    EXPECT_NEAR(displacements[0].y, -0.05f, 1e-6f);
}

struct Crowd {
    Triangles mesh = folded_packet(6, 24, 8, 0.03f, 2e-3f);
    LaidOut<PairList> pairs = all_pairs(mesh);
    Rows wanted = random_vectors(mesh.size(), 2e-3f, 4);
    Crowd() {
        for (std::uint32_t i = 0; i < mesh.size(); ++i) mesh.positions[i].w = 1 + static_cast<float>(i % 5);
    }
    double lacking(const Rows& displacements, double wanted_gap) const {
        double sum = 0;
        for (std::uint32_t k = 0; k < pairs.size; ++k) {
            const float* const weights = &pairs.shapes[k].weights.x;
            Point between = Point::Zero();
            for (std::size_t i = 0; i < 4; ++i) {
                const std::uint32_t p = pairs.pairs[k].corners[i];
                between += double{weights[i]} * (point(mesh.positions[p]) + point(displacements[p]));
            }
            sum += std::pow(std::max(0.0, wanted_gap - between.dot(point(pairs.shapes[k].normal))), 2);
        }
        return sum;
    }
};

TEST(PairProjection, ACrowdKeepsItsMomentumAndComesApart) {
    const Crowd crowd;
    Rows displacements = crowd.wanted;
    EXPECT_GT(project(crowd.mesh.positions, crowd.pairs, 2e-3f, 4, displacements), 100u);
    Point change = Point::Zero();
    double sum = 0;
    for (std::size_t i = 0; i < displacements.size(); ++i) {
        const Point moved = point(displacements[i]) - point(crowd.wanted[i]);
        change += moved / double{crowd.mesh.positions[i].w};
        sum += moved.norm() / double{crowd.mesh.positions[i].w};
    }
    EXPECT_GT(sum, 0.01);
    EXPECT_LT(change.norm(), 1e-5 * sum);
    EXPECT_LT(crowd.lacking(displacements, 2e-3), 0.5 * crowd.lacking(crowd.wanted, 2e-3));
}

TEST(PairProjection, NeitherThreadsNorACommonMotionChangeIt) {
    const Crowd crowd;
    Rows one = crowd.wanted, four = crowd.wanted, fast = crowd.wanted;
    for (Vec4& d : fast) d.y += 64;
    project(crowd.mesh.positions, crowd.pairs, 2e-3f, 4, one);
    project(crowd.mesh.positions, crowd.pairs, 2e-3f, 4, four, {}, 4);
    project(crowd.mesh.positions, crowd.pairs, 2e-3f, 4, fast);
    EXPECT_EQ(std::memcmp(one.data(), four.data(), one.size() * sizeof(Vec4)), 0);
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(fast[i].y - 64, one[i].y, 1e-4f);
}

TEST(PairProjection, WhatIsNotANumberStaysWithIt) {
    Crowd crowd;
    crowd.wanted[30].y = std::numeric_limits<float>::quiet_NaN();
    crowd.wanted[40].y = -std::numeric_limits<float>::infinity();
    Rows displacements = crowd.wanted;
    project(crowd.mesh.positions, crowd.pairs, 2e-3f, 4, displacements);
    for (std::size_t i = 0; i < displacements.size(); ++i) {
        EXPECT_EQ(xyz(displacements[i]).allFinite(), i != 30 && i != 40) << i;
    }
}

TEST(PairIncidence, RowsAreThoseOfALoopOverPairs) {
    std::mt19937 random(2);
    std::uniform_int_distribution<std::uint32_t> any(0, 4999);
    const std::uint32_t size = 9000;
    std::vector<FeaturePair> pairs(size);
    std::vector<std::uint8_t> chosen(size);
    for (std::uint32_t k = 0; k < size; ++k) {
        for (std::uint32_t& corner : pairs[k].corners) corner = 3 * any(random) / (1 + k % 3);
        chosen[k] = k % 7 != 0;
    }
    LaidOut<PairIncidence> incidence;
    incidence.reserve(15000, size);
    for (const int threads : {1, 4}) {
        for (const bool all : {false, true}) {
            std::vector<std::vector<std::uint32_t>> rows(15000);
            for (std::uint32_t k = 0; k < size; ++k) {
                for (std::uint32_t i = 0; i < 4; ++i) {
                    if (all || chosen[k] != 0) rows[pairs[k].corners[i]].push_back(4 * k + i);
                }
            }
            Parallel parallel(threads);
            incidence.build(parallel, pairs, all ? std::span<const std::uint8_t>() : chosen);
            std::uint32_t row = 0;
            for (std::uint32_t i = 0; i < 15000; ++i) {
                if (rows[i].empty()) continue;
                ASSERT_LT(row, incidence.rows());
                ASSERT_EQ(incidence.particle(row), i);
                const auto places = incidence.places(row++);
                ASSERT_TRUE(std::ranges::equal(places, rows[i])) << i;
            }
            EXPECT_EQ(row, incidence.rows());
        }
    }
}

TEST(Leverage, BoundsWhatPinsLeaveLittleToDo) {
    EXPECT_FLOAT_EQ(mobility_of_gap({2, 2, 2, 2}, {1, -0.5f, -0.25f, -0.25f}), 2 * 1.375f) << "unbounded";
    EXPECT_FLOAT_EQ(mobility_of_gap({0, 2, 2, 2}, {1, -0.5f, -0.25f, -0.25f}), 2 * 0.375f) << "unbounded";
    EXPECT_FLOAT_EQ(mobility_of_gap({0, 0, 2, 0}, {1, -0.65f, -0.35f, 0}), 2 * 0.35f / farthest_for_gap);
    EXPECT_EQ(mobility_of_gap({0, 0, 2, 2}, {1, -0.45f, -0.29f, -0.26f}), 0);
    EXPECT_EQ(mobility_of_gap({0, 0, 0, 0}, {1, -0.5f, -0.25f, -0.25f}), 0);
}

}  // namespace
}  // namespace weft::test
