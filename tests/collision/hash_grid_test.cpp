#include "collision/search/hash_grid.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "tests/collision/contact/crumpled_sheet.h"

namespace weft::test {
namespace {

std::vector<Vec4> random_cloud(std::uint32_t n, float size, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0, size);
    std::vector<Vec4> cloud(n);
    for (Vec4& p : cloud) p = {uniform(random), uniform(random), uniform(random), 1};
    return cloud;
}

/// Every pair closer than the distance is among the ranges that the grid names, whatever the table's size.
void expect_covers_brute_force(const std::vector<Vec4>& positions, float distance,
                               std::uint32_t bucket_count) {
    const auto n = static_cast<std::uint32_t>(positions.size());
    Parallel parallel(1);
    HashGrid grid(n, bucket_count);
    grid.build_rows(parallel, positions, bounds_of(positions), distance);
    std::size_t close_pairs = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
        std::set<std::uint32_t> candidates;
        const HashGrid::Near near = grid.near(positions[i].x, positions[i].y, positions[i].z);
        for (std::uint32_t r = 0; r < near.count; ++r) {
            candidates.insert(grid.particles() + near.ranges[r].begin, grid.particles() + near.ranges[r].end);
        }
        for (std::uint32_t j = 0; j < n; ++j) {
            const float dx = positions[i].x - positions[j].x, dy = positions[i].y - positions[j].y,
                        dz = positions[i].z - positions[j].z;
            if (!(dx * dx + dy * dy + dz * dz < distance * distance)) continue;
            ++close_pairs;
            ASSERT_TRUE(candidates.contains(j))
                << i << " and " << j << " with " << bucket_count << " buckets";
        }
    }
    EXPECT_GT(close_pairs, n);  // more than each with itself
}

TEST(HashGrid, NearRangesCoverAllClosePairsForAnyTable) {
    const std::vector<Vec4> cloud = random_cloud(600, 1, 11);
    for (const std::uint32_t buckets : {4u, 8u, 64u, 2048u, 1u << 16}) {
        expect_covers_brute_force(cloud, 0.12f, buckets);
    }
}

TEST(HashGrid, ExactWhereRoundingDecidesTheCell) {
    // A particle far away makes (coordinate - origin) coarser than the coordinates are. Around the borders of
    // cells just as wide as the distance, that rounding would put many a pair two cells apart.
    const float distance = 0.1f, far = -1000.03f;
    for (int axis = 0; axis < 3; ++axis) {
        const auto on_axis = [&](float coordinate) {
            return Vec4{axis == 0 ? coordinate : 0, axis == 1 ? coordinate : 0, axis == 2 ? coordinate : 0,
                        1};
        };
        std::vector<Vec4> line{on_axis(far)};
        for (int cell = 9990; cell < 10020; ++cell) {
            const double border = static_cast<double>(far) + static_cast<double>(distance) * cell;
            for (int step = -30; step <= 30; ++step)
                line.push_back(on_axis(static_cast<float>(border + 4e-6 * step)));
        }
        expect_covers_brute_force(line, distance, 1u << 16);
    }
}

}  // namespace
}  // namespace weft::test
