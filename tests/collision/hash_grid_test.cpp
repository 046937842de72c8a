#include "collision/search/hash_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>

#include "tests/collision/contact/crumpled_sheet.h"

namespace weft::test {
namespace {

std::vector<std::uint32_t> order_of(const HashGrid& grid, std::size_t n) {
    return {grid.particles(), grid.particles() + n};
}

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

TEST(HashGrid, SortsEveryParticleIntoOneSlotWithItsPosition) {
    const std::vector<Vec4> cloud = random_cloud(3000, 1, 7);
    Parallel parallel(2);
    HashGrid grid(3000);
    grid.build_rows(parallel, cloud, bounds_of(cloud), 0.02f);
    std::vector<std::uint32_t> particles = order_of(grid, 3000);
    for (std::size_t s = 0; s < particles.size(); ++s) {
        EXPECT_EQ(grid.x()[s], cloud[particles[s]].x);
        EXPECT_EQ(grid.y()[s], cloud[particles[s]].y);
        EXPECT_EQ(grid.z()[s], cloud[particles[s]].z);
    }
    std::sort(particles.begin(), particles.end());
    for (std::uint32_t i = 0; i < 3000; ++i) EXPECT_EQ(particles[i], i);
}

TEST(HashGrid, OrderDoesNotDependOnTheNumberOfThreads) {
    const Sheet sheet = crumpled_sheet(50);
    const auto n = static_cast<std::uint32_t>(sheet.positions.size());
    const Bounds bounds = bounds_of(sheet.positions);
    const auto order = [&](int threads, bool cubes) {
        Parallel parallel(threads);
        HashGrid grid(n);
        if (cubes) {
            grid.build_cubes(parallel, sheet.positions, bounds, 0.02f, 0.5f);
        } else {
            grid.build_rows(parallel, sheet.positions, bounds, 0.02f);
        }
        return order_of(grid, n);
    };
    for (const bool cubes : {false, true}) {
        for (const int threads : {2, 3, 8, 100}) EXPECT_EQ(order(threads, cubes), order(1, cubes)) << threads;
    }
}

TEST(HashGrid, SlotsAscendWithTheParticleInsideABucket) {
    const std::vector<Vec4> cloud = random_cloud(4000, 1, 3);
    Parallel parallel(3);
    HashGrid grid(4000, 64);
    grid.build_cubes(parallel, cloud, bounds_of(cloud), 0.1f, 0);
    for (const Vec4& p : cloud) {
        const SlotRange bucket = grid.own_bucket(p.x, p.y, p.z);
        EXPECT_TRUE(std::is_sorted(grid.particles() + bucket.begin, grid.particles() + bucket.end));
    }
}

TEST(HashGrid, NearRangesCoverAllClosePairsForAnyTable) {
    const std::vector<Vec4> cloud = random_cloud(600, 1, 11);
    for (const std::uint32_t buckets : {4u, 8u, 64u, 2048u, 1u << 16}) {
        expect_covers_brute_force(cloud, 0.12f, buckets);
    }
}

TEST(HashGrid, NearRangesCoverClosePairsFarFromTheOriginAndWhenOneParticleFlewOff) {
    std::vector<Vec4> cloud = random_cloud(600, 1, 12);
    for (Vec4& p : cloud) p = {p.x + 4000, p.y - 9000, p.z + 12000, 1};
    expect_covers_brute_force(cloud, 0.12f, 2048);
    cloud[17] = {1e7f, -1e7f, 3e6f, 1};
    expect_covers_brute_force(cloud, 0.12f, 2048);
    cloud[18] = {3e38f, -3e38f, 3e38f, 1};
    expect_covers_brute_force(cloud, 0.12f, 2048);
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

TEST(HashGrid, CoordinatesThatAreNotFiniteNeitherOverflowNorCrowdOneBucket) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                    inf = std::numeric_limits<float>::infinity();
    std::vector<Vec4> cloud(2000, Vec4{nan, inf, -inf, 1});
    cloud[5] = {1, 2, 3, 1};
    Parallel parallel(2);
    HashGrid grid(2000);
    for (const Bounds& bounds : {Bounds{{nan, inf, -inf}, {nan, nan, nan}}, Bounds{{1, 2, 3}, {1, 2, 3}}}) {
        grid.build_cubes(parallel, cloud, bounds, 0.1f, 0.5f);
        EXPECT_LE(grid.own_bucket(1, 2, 3).end - grid.own_bucket(1, 2, 3).begin, 3u);
        EXPECT_LE(grid.own_bucket(nan, inf, -inf).end - grid.own_bucket(nan, inf, -inf).begin, 3u);
    }
}

TEST(HashGrid, EmptyGridHasEmptyRanges) {
    Parallel parallel(2);
    HashGrid grid(0);
    grid.build_rows(parallel, {}, Bounds{{1, 1, 1}, {-1, -1, -1}}, 0.1f);
    const HashGrid::Near near = grid.near(0, 0, 0);
    for (std::uint32_t r = 0; r < near.count; ++r) EXPECT_EQ(near.ranges[r].begin, near.ranges[r].end);
}

}  // namespace
}  // namespace weft::test
