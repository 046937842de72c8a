#include "collision/particles/rest_neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "tests/collision/contact/crumpled_sheet.h"

namespace weft::test {
namespace {

/// A crumpled sheet's joins, with lengths that differ from one to the other but not from end to end.
struct Joins {
    Sheet sheet;
    std::vector<float> lengths;

    explicit Joins(std::uint32_t side, float spread = 0) : sheet(crumpled_sheet(side)) {
        std::mt19937 random(11);
        std::uniform_real_distribution<float> factor(1 - spread, 1 + spread);
        lengths.resize(sheet.neighbours.size());
        for_each([&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
            const float du = sheet.rest[i].x - sheet.rest[j].x, dv = sheet.rest[i].z - sheet.rest[j].z;
            if (i < j) lengths[k] = factor(random) * std::hypot(du, dv);
        });
        for_each([&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
            const auto row = sheet.neighbours.begin() + sheet.offsets[j];
            const auto back = std::find(row, sheet.neighbours.end(), i) - sheet.neighbours.begin();
            if (i > j) lengths[k] = lengths[static_cast<std::size_t>(back)];
        });
    }
    template <class Use>
    void for_each(const Use& use) const {
        for (std::uint32_t i = 0; i + 1 < sheet.offsets.size(); ++i)
            for (std::uint32_t k = sheet.offsets[i]; k < sheet.offsets[i + 1]; ++k)
                use(i, sheet.neighbours[k], k);
    }
    [[nodiscard]] RestGraph graph() const { return {sheet.offsets, sheet.neighbours, lengths}; }
    [[nodiscard]] std::size_t size() const { return sheet.positions.size(); }
};

/// All shortest ways (Floyd 1962), and whether two are joined.
struct AllWays {
    std::vector<std::vector<double>> way;
    std::vector<std::vector<bool>> joined;

    explicit AllWays(const Joins& joins)
        : way(joins.size(), std::vector<double>(joins.size(), std::numeric_limits<double>::infinity())),
          joined(joins.size(), std::vector<bool>(joins.size(), false)) {
        joins.for_each([&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
            way[i][j] = static_cast<double>(joins.lengths[k]);
            joined[i][j] = true;
        });
        for (std::size_t k = 0; k < way.size(); ++k)
            for (std::size_t i = 0; i < way.size(); ++i)
                for (std::size_t j = 0; j < way.size(); ++j)
                    way[i][j] = std::min(way[i][j], way[i][k] + way[k][j]);
    }
};

TEST(RestNeighbours, AreThoseThatAreJoinedOrNearAlongTheCloth) {
    const Joins joins(14, 0.3f);
    const AllWays all(joins);
    for (const float edges : {0.1f, 0.75f, 1.3f, 2.9f, 6.1f}) {
        const float distance = edges / 14;
        const RestNeighbours near = RestNeighbours::find(joins.graph(), distance).value();
        EXPECT_EQ(near.distance(), distance);
        const RestFilter filter = near.filter();
        std::size_t left_alone = 0, longest = 0;
        for (std::uint32_t i = 0; i < joins.size(); ++i) {
            const auto list =
                filter.neighbours.subspan(filter.offsets[i], filter.offsets[i + 1] - filter.offsets[i]);
            EXPECT_TRUE(std::ranges::is_sorted(list));
            longest = std::max(longest, list.size());
            left_alone += list.size();
            for (std::uint32_t j = 0; j < joins.size(); ++j) {
                if (i == j) continue;
                const bool expected =
                    all.joined[i][j] || all.way[i][j] < 1.25 * static_cast<double>(distance);
                EXPECT_EQ(filter.leaves_alone(i, j), expected) << i << " and " << j << ", " << edges;
                EXPECT_EQ(filter.leaves_alone(j, i), expected) << i << " and " << j << ", " << edges;
            }
            EXPECT_FALSE(filter.leaves_alone(i, i));
        }
        if (edges < 0.7f) {
            EXPECT_EQ(left_alone, joins.sheet.neighbours.size());
        } else if (edges > 6) {
            EXPECT_GT(longest, 100u) << "long lists are to be looked through, too";
        }
    }
}

TEST(RestNeighbours, PiecesThatAreNotJoinedAreNeverNear) {
    const std::vector<std::uint32_t> offsets{0, 1, 2, 3, 4}, neighbours{1, 0, 3, 2};
    const std::vector<float> lengths(4, 1.0f);
    const RestNeighbours near = RestNeighbours::find({offsets, neighbours, lengths}, 100).value();
    for (const std::uint32_t i : {0u, 1u})
        for (const std::uint32_t j : {2u, 3u}) EXPECT_FALSE(near.filter().leaves_alone(i, j));
    EXPECT_TRUE(near.filter().leaves_alone(2, 3));
}

TEST(RestNeighbours, ADistanceOfManyEdgesIsAnErrorThatNamesItUnlessTheClothIsSmall) {
    const auto large = RestNeighbours::find(Joins(64).graph(), 0.25f);
    ASSERT_FALSE(large.ok());
    EXPECT_EQ(large.error().code, ErrorCode::invalid_argument);
    EXPECT_NE(large.error().message.find("SelfCollision::distance is 0.25"), std::string::npos)
        << large.error().message;
    EXPECT_TRUE(RestNeighbours::find(Joins(64).graph(), 7.0f / 64).ok());

    const RestNeighbours whole = RestNeighbours::find(Joins(16).graph(), 1e30f).value();
    EXPECT_EQ(whole.filter().neighbours.size(), 256u * 255u);
}

}  // namespace
}  // namespace weft::test
