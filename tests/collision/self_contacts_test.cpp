#include "collision/particles/self_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "tests/collision/contact/crumpled_sheet.h"

namespace weft::test {
namespace {

using Lists = std::vector<std::vector<std::uint32_t>>;

Lists brute_force(const std::vector<Vec4>& positions, const RestFilter& filter, float distance) {
    const auto closer = [&](const Vec4& a, const Vec4& b) {
        const float dx = a.x - b.x, dy = a.y - b.y, dz = a.z - b.z;
        return dx * dx + dy * dy + dz * dz < distance * distance;
    };
    const auto joined = [&](std::uint32_t i, std::uint32_t j) {
        if (filter.offsets.empty()) return false;
        const auto begin = filter.neighbours.begin();
        return std::find(begin + filter.offsets[i], begin + filter.offsets[i + 1], j) !=
               begin + filter.offsets[i + 1];
    };
    Lists lists(positions.size());
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        for (std::uint32_t j = 0; j < positions.size(); ++j) {
            if (i == j || !closer(positions[i], positions[j]) || joined(i, j)) continue;
            lists[i].push_back(j);
        }
    }
    return lists;
}

Lists found_from(const std::vector<Vec4>& rest_positions, const std::vector<Vec4>& positions,
                 const RestFilter& filter, float distance, SelfCollisionSearch search, int threads = 1) {
    Parallel parallel(threads);
    SelfContacts contacts(rest_positions, search);
    contacts.find(parallel, positions, filter, distance, search);
    Lists lists;
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        const auto list = contacts.contacts(i);
        lists.emplace_back(list.begin(), list.end());
    }
    return lists;
}

/// As if it lay at rest as it lies now, as far as that is finite.
Lists found(const std::vector<Vec4>& positions, const RestFilter& filter, float distance,
            SelfCollisionSearch search, int threads = 1) {
    std::vector<Vec4> rest = positions;
    for (Vec4& p : rest)
        if (!std::isfinite(p.x + p.y + p.z)) p = {};
    return found_from(rest, positions, filter, distance, search, threads);
}

constexpr std::array all_searches{SelfCollisionSearch::exact, SelfCollisionSearch::shifted_grids,
                                  SelfCollisionSearch::sorted_sweep};

std::size_t entries(const Lists& lists) {
    std::size_t sum = 0;
    for (const auto& list : lists) sum += list.size();
    return sum;
}

void expect_exact(const std::vector<Vec4>& positions, const RestFilter& filter, float distance) {
    const Lists expected = brute_force(positions, filter, distance);
    for (const auto& list : expected)
        ASSERT_LE(list.size(), SelfContacts::capacity) << "the test's own set is too dense";
    for (const auto search : {SelfCollisionSearch::exact, SelfCollisionSearch::sorted_sweep})
        EXPECT_EQ(found(positions, filter, distance, search), expected)
            << "distance " << distance << ", search " << static_cast<int>(search);
}

std::vector<Vec4> random_particles(std::uint32_t n, float size, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-size, size);
    std::vector<Vec4> cloud(n);
    for (Vec4& p : cloud) p = {uniform(random), uniform(random), uniform(random), 1};
    return cloud;
}

TEST(SelfContacts, ExactEqualsBruteForceOnCrumpledSheets) {
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        const Sheet sheet = crumpled_sheet(40, seed);
        for (const float edges : {0.3f, 0.75f, 0.95f})
            expect_exact(sheet.positions, sheet.filter(), edges / 40);
    }
    const Sheet sheet = crumpled_sheet(40);
    EXPECT_GT(entries(brute_force(sheet.positions, sheet.filter(), 0.75f / 40)), 50u);
}

TEST(SelfContacts, ExactEqualsBruteForceOnRandomClouds) {
    for (const float distance : {0.001f, 0.02f, 0.1f, 0.15f})
        expect_exact(random_particles(1500, 1, 5), {}, distance);
}

TEST(SelfContacts, ExactEqualsBruteForceForFewParticlesWhoseRowsShareBuckets) {
    std::size_t contacts = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        const std::vector<Vec4> cloud = random_particles(2 + seed % 15, 1, seed);
        expect_exact(cloud, {}, 0.9f);
        contacts += entries(brute_force(cloud, {}, 0.9f));
    }
    EXPECT_GT(contacts, 1000u);
}

TEST(SelfContacts, ExactEqualsBruteForceOnLinesAlongEveryAxis) {
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<Vec4> line(700);
        for (std::size_t i = 0; i < line.size(); ++i) {
            float coordinates[3] = {1, 1, 1};
            coordinates[axis] = 0.03f * static_cast<float>(i * 389 % line.size());
            line[i] = {coordinates[0], coordinates[1], coordinates[2], 1};
        }
        for (const float distance : {0.02f, 0.04f, 0.1f}) expect_exact(line, {}, distance);
    }
}

TEST(SelfContacts, ExactEqualsBruteForceOnCoincidentClusters) {
    std::vector<Vec4> clusters = random_particles(200, 1, 9);
    for (std::size_t copy = 0; copy < 5; ++copy) {
        for (std::size_t i = 0; i < 200; ++i) clusters.push_back(clusters[i]);
    }
    expect_exact(clusters, {}, 0.02f);
}

TEST(SelfContacts, ExactEqualsBruteForceForHugeCoordinates) {
    std::vector<Vec4> cloud = random_particles(500, 1, 4);
    cloud[3] = {3e38f, 3e38f, -3e38f, 1};
    cloud[4] = cloud[3];
    cloud[7] = {-3e38f, 1e20f, 0, 1};
    cloud[9] = {1e9f, 1e9f, 1e9f, 1};
    expect_exact(cloud, {}, 0.1f);
    for (Vec4& p : cloud) p.x += 1e5f;
    expect_exact(cloud, {}, 0.1f);
}

TEST(SelfContacts, ParticlesThatAreNotFiniteHaveNoContacts) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                    inf = std::numeric_limits<float>::infinity();
    std::vector<Vec4> cloud = random_particles(500, 1, 4);
    for (std::size_t i = 0; i < 500; i += 7) cloud[i].y = nan;
    for (std::size_t i = 3; i < 500; i += 7) cloud[i].z = -inf;
    expect_exact(cloud, {}, 0.1f);
    std::fill(cloud.begin(), cloud.end(), Vec4{nan, nan, nan, 1});
    for (const auto search : all_searches) EXPECT_EQ(entries(found(cloud, {}, 0.1f, search)), 0u);
}

TEST(SelfContacts, NoParticlesAndOneParticleHaveNoContacts) {
    for (const auto search : all_searches) {
        EXPECT_EQ(entries(found({}, {}, 0.1f, search)), 0u);
        EXPECT_EQ(entries(found({{1, 2, 3, 1}}, {}, 0.1f, search)), 0u);
    }
}

TEST(SelfContacts, ListsAreTheSameForAnyNumberOfThreads) {
    const Sheet sheet = crumpled_sheet(64);
    const float crowded = 3.0f / 64;  // many lists overflow
    for (const auto search : all_searches) {
        for (const float distance : {0.75f / 64, crowded}) {
            const Lists one = found(sheet.positions, {}, distance, search, 1);
            EXPECT_GT(entries(one), 0u);
            for (const int threads : {2, 3, 8})
                EXPECT_EQ(found(sheet.positions, {}, distance, search, threads), one);
        }
    }
}

TEST(SelfContacts, FullListsAreAscendingDistinctAndTrue) {
    const Sheet sheet = crumpled_sheet(40);
    const float distance = 4.0f / 40;
    const Lists all = brute_force(sheet.positions, {}, distance);
    for (const auto search : {SelfCollisionSearch::exact, SelfCollisionSearch::sorted_sweep}) {
        const Lists kept = found(sheet.positions, {}, distance, search);
        std::size_t full = 0;
        for (std::size_t i = 0; i < kept.size(); ++i) {
            EXPECT_EQ(kept[i].size(), std::min<std::size_t>(all[i].size(), SelfContacts::capacity));
            EXPECT_TRUE(std::includes(all[i].begin(), all[i].end(), kept[i].begin(), kept[i].end()));
            EXPECT_EQ(std::adjacent_find(kept[i].begin(), kept[i].end(), std::greater_equal<>{}),
                      kept[i].end());
            full += all[i].size() > SelfContacts::capacity ? 1 : 0;
        }
        EXPECT_GT(full, 100u);
    }
}

TEST(SelfContacts, CrowdsAtOnePointFillAllListsByEverySearch) {
    // More than a block's range of slots, at one point and around it: lists are full, and soon.
    std::vector<Vec4> crowd(3000, Vec4{1, 2, 3, 1});
    for (std::size_t i = 0; i < crowd.size(); i += 3) crowd[i].y += 1e-4f * static_cast<float>(i % 30);
    for (const auto search : all_searches) {
        const Lists lists = found(crowd, {}, 0.1f, search);
        for (std::uint32_t i = 0; i < lists.size(); ++i) {
            EXPECT_EQ(lists[i].size(), SelfContacts::capacity) << i;
            EXPECT_EQ(std::ranges::find(lists[i], i), lists[i].end()) << "not one's own contact";
        }
    }
}

TEST(SelfContacts, SweepIsExactWhereColumnsAreWiderThanTheDistance) {
    // 253 columns of the distance would reach over a tenth of this plane; the distance is some edges of sweep
    // cells, too. Layers close to one another, so that there are pairs in all directions.
    for (int longest = 0; longest < 3; ++longest) {
        std::mt19937 random(static_cast<std::uint32_t>(longest) + 7);
        std::uniform_real_distribution<float> uniform(0, 1);
        std::vector<Vec4> cloud(3000);
        for (std::size_t i = 0; i < cloud.size(); ++i) {
            float p[3];
            for (int axis = 0; axis < 3; ++axis)
                p[axis] = (axis == longest ? 60.0f : 50.0f) * uniform(random);
            cloud[i] = {p[0], p[1], p[2], 1};
            if (i % 2 == 0) continue;
            const Vec4& near = cloud[i - 1];  // the first of the two has a partner
            cloud[i] = {near.x + 0.02f * (uniform(random) - 0.5f), near.y + 0.02f * (uniform(random) - 0.5f),
                        near.z + 0.02f * (uniform(random) - 0.5f), 1};
        }
        const Lists expected = brute_force(cloud, {}, 0.012f);
        EXPECT_GT(entries(expected), 1000u);
        EXPECT_EQ(found(cloud, {}, 0.012f, SelfCollisionSearch::sorted_sweep), expected) << longest;
    }
}

TEST(SelfContacts, SweepIsExactWhereRoundingDecidesTheColumn) {
    // Two particles about a distance apart, around the borders of columns: one to be found, or not, by a bit.
    const float distance = 0.1f;
    const auto find_pair = [&](SelfContacts& contacts, int axis, float extent, float p, float q) {
        std::array<Vec4, 4> points{{{0, 0, 0, 1}, {extent, extent, extent, 1}}};
        for (const std::size_t k : {std::size_t{2}, std::size_t{3}}) {
            float at[3] = {0.5f * extent, 0.5f * extent, 0.5f * extent};
            at[axis] = k == 2 ? p : q;
            points[k] = {at[0], at[1], at[2], 1};
        }
        Parallel serial(1);
        contacts.find(serial, points, {}, distance, SelfCollisionSearch::sorted_sweep);
        return contacts.contacts(2).size() == 1 && contacts.contacts(3).size() == 1;
    };
    SelfContacts contacts(std::vector<Vec4>(4), SelfCollisionSearch::sorted_sweep);
    int found = 0;
    for (const float extent : {20.0f, 24.9f}) {
        for (int cell = 100; cell < 190; cell += 3) {
            const float border = static_cast<float>(cell) * distance, other = border + distance;
            for (int i = -5; i <= 5; ++i) {
                for (int j = -5; j <= 5; ++j) {
                    const float p = border + 1e-6f * static_cast<float>(i),
                                q = other + 1e-6f * static_cast<float>(j);
                    const bool is_close = (p - q) * (p - q) < distance * distance;
                    found += is_close ? 1 : 0;
                    for (int axis = 0; axis < 3; ++axis)
                        ASSERT_EQ(find_pair(contacts, axis, extent, p, q), is_close) << p << " and " << q;
                }
            }
        }
    }
    EXPECT_GT(found, 1000);
}

TEST(SelfContacts, SweepFindsTheFarthestOfClosePairsAboutTheBordersOfAllColumns) {
    // A box that the origin is in: taking its corner off a coordinate rounds by more than the coordinate
    // does.
    const float distance = 0.1f, lower = -7.3f, upper = lower + 24.9f;
    SelfContacts contacts(std::vector<Vec4>(4), SelfCollisionSearch::sorted_sweep);
    Parallel serial(1);
    for (int cell = 1; cell < 247; ++cell) {
        float p = lower + distance * static_cast<float>(cell);
        for (int k = 0; k < 12; ++k) p = std::nextafter(p, lower);
        for (int k = 0; k < 24; ++k, p = std::nextafter(p, upper)) {
            const float step = 8e-8f * std::max(std::abs(p + distance), distance);
            float q = p + distance + 4 * step;
            while (!((p - q) * (p - q) < distance * distance)) q -= step;
            for (int axis = 1; axis < 3; ++axis) {
                std::array<Vec4, 4> points{{{lower, lower, lower, 1}, {upper, upper, upper, 1}, {}, {}}};
                points[2] = axis == 1 ? Vec4{1, p, 1, 1} : Vec4{1, 1, p, 1};
                points[3] = axis == 1 ? Vec4{1, q, 1, 1} : Vec4{1, 1, q, 1};
                contacts.find(serial, points, {}, distance, SelfCollisionSearch::sorted_sweep);
                ASSERT_EQ(contacts.contacts(2).size(), 1u) << p << " and " << q;
            }
        }
    }
}

/// True if both particles are in one cube of the grid with this shift, clear of its faces.
bool share_a_cube(const Vec4& a, const Vec4& b, const Vec3& origin, float edge, double shift) {
    const auto same_cell = [&](float p, float q, float from) {
        const double u = static_cast<double>(p - from) / static_cast<double>(edge) + shift;
        const double v = static_cast<double>(q - from) / static_cast<double>(edge) + shift;
        const auto clear = [](double cell) { return std::abs(cell - std::round(cell)) > 0.02; };
        return std::floor(u) == std::floor(v) && clear(u) && clear(v);
    };
    return same_cell(a.x, b.x, origin.x) && same_cell(a.y, b.y, origin.y) && same_cell(a.z, b.z, origin.z);
}

TEST(SelfContacts, ShiftedGridsFindThePairsThatShareACubeAndNoFalseOnes) {
    const Sheet sheet = crumpled_sheet(128);
    const float distance = 0.75f / 128;
    const Vec3 origin = bounds_of(sheet.positions).lower;
    const Lists all = found(sheet.positions, sheet.filter(), distance, SelfCollisionSearch::exact);
    const Lists some = found(sheet.positions, sheet.filter(), distance, SelfCollisionSearch::shifted_grids);
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        EXPECT_TRUE(std::includes(all[i].begin(), all[i].end(), some[i].begin(), some[i].end()));
        for (const std::uint32_t j : some[i]) {
            EXPECT_TRUE(std::binary_search(some[j].begin(), some[j].end(), i)) << "contacts come in pairs";
        }
        for (const std::uint32_t j : all[i]) {
            const Vec4 &a = sheet.positions[i], &b = sheet.positions[j];
            if (!share_a_cube(a, b, origin, distance, 0) && !share_a_cube(a, b, origin, distance, 0.5))
                continue;
            EXPECT_TRUE(std::binary_search(some[i].begin(), some[i].end(), j)) << i << " and " << j;
        }
    }
    // For pairs at all distances up to the threshold geometry expects 0.4; resting layers, whose pairs are
    // all nearly that far apart, are found less often still.
    const double recall = static_cast<double>(entries(some)) / static_cast<double>(entries(all));
    RecordProperty("recall", std::to_string(recall));
    EXPECT_GT(recall, 0.1);
    EXPECT_LT(recall, 0.5);
}

TEST(SelfContacts, PairsBetweenPatchesAreFoundUpToTheLastBitOfTheDistance) {
    // Two patches of particles that lie together, a whole distance apart along one axis.
    for (const float distance : {0.1f, 0.3f, 1.7f}) {
        for (const float apart : {std::nextafter(distance, 0.0f), distance, std::nextafter(distance, 9.0f)}) {
            for (int axis = 0; axis < 3; ++axis) {
                std::vector<Vec4> points(32, Vec4{0, 0, 0, 1});
                for (std::uint32_t i = 0; i < 32; ++i) {
                    const float far = 10 * static_cast<float>(i % 16);
                    float p[3] = {0, 0, 0};
                    p[axis] = i < 16 ? 0 : apart;
                    p[(axis + 1) % 3] = far * distance;
                    points[i] = {p[0], p[1], p[2], 1};
                }
                std::vector<Vec4> rest(32);
                for (std::uint32_t i = 0; i < 32; ++i)
                    rest[i] = {i < 16 ? 0.0f : 1000.0f, static_cast<float>(i), 0, 0};
                const Lists expected = brute_force(points, {}, distance);
                EXPECT_EQ(entries(expected), apart < distance ? 32u : 0u);
                for (const auto search : {SelfCollisionSearch::exact, SelfCollisionSearch::sorted_sweep})
                    EXPECT_EQ(found_from(rest, points, {}, distance, search), expected);
            }
        }
    }
}

TEST(SelfContacts, PairsOfTheRestFilterAreLeftAlone) {
    const std::vector<Vec4> positions{{0, 0, 0, 1}, {0.01f, 0, 0, 1}, {0.02f, 0, 0, 1}, {0.03f, 0, 0, 1}};
    const std::vector<std::uint32_t> offsets{0, 1, 3, 4, 4}, neighbours{1, 0, 2, 1};
    for (const auto search : {SelfCollisionSearch::exact, SelfCollisionSearch::sorted_sweep}) {
        const Lists lists = found(positions, {offsets, neighbours}, 0.1f, search);
        EXPECT_EQ(lists, (Lists{{2, 3}, {3}, {0, 3}, {0, 1, 2}}));
    }
}

std::vector<Vec4> shuffled(std::vector<Vec4> positions) {
    std::shuffle(positions.begin(), positions.end(), std::mt19937(3));
    return positions;
}

TEST(SelfContacts, ExactWhateverLayTogetherAtRest) {
    const Sheet sheet = crumpled_sheet(64);
    const float distance = 0.75f / 64;
    const Lists expected = brute_force(sheet.positions, {}, distance);
    ASSERT_GT(entries(expected), 1000u);
    const auto found_now = [&](const std::vector<Vec4>& rest) {
        return found_from(rest, sheet.positions, {}, distance, SelfCollisionSearch::exact);
    };
    EXPECT_EQ(found_now(sheet.rest), expected);
    EXPECT_EQ(found_now(shuffled(sheet.rest)), expected) << "patches spread over all of the cloth";
    EXPECT_EQ(found_now(std::vector<Vec4>(sheet.rest.size())), expected) << "all at one point";
}

TEST(SelfContacts, ExactWhereACrowdLiesInACalmSheet) {
    // Of some patches particles have more contacts than fit a list's search, of most none.
    std::vector<Vec4> positions = crumpled_sheet(64).rest;
    for (std::uint32_t i = 0; i < 40; ++i)
        positions[1000 + 7 * i] = {0.3f, 0.1f + 1e-4f * static_cast<float>(i), 0, 1};
    const float distance = 0.75f / 64;
    const Lists all = brute_force(positions, {}, distance);
    const Lists kept =
        found_from(crumpled_sheet(64).rest, positions, {}, distance, SelfCollisionSearch::exact);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(kept[i].size(), std::min<std::size_t>(all[i].size(), SelfContacts::capacity)) << i;
        EXPECT_TRUE(std::includes(all[i].begin(), all[i].end(), kept[i].begin(), kept[i].end())) << i;
    }
}

}  // namespace
}  // namespace weft::test
