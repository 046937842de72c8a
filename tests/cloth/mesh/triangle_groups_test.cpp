// Triangles in groups against the lists that they are made from.

#include "cloth/surface/triangle_groups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <vector>

#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

constexpr std::uint32_t group_lanes = TriangleGroups::lanes;

std::uint32_t row_at(std::uint32_t offset) {
    EXPECT_EQ(offset % sizeof(Vec4), 0u);
    return offset / static_cast<std::uint32_t>(sizeof(Vec4));
}

std::vector<Triangle> triangles_in(const TriangleGroups& groups) {
    std::vector<Triangle> rows(groups.rows);
    for (std::uint32_t row = 0; row < groups.rows; ++row) {
        const std::uint32_t lane = row % group_lanes;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t source = groups.corner_sources[row / group_lanes * 3 + k];
            rows[row][k] = source < TriangleGroups::listed
                               ? source + lane
                               : row_at(groups.corner_lists[source - TriangleGroups::listed + lane]);
        }
    }
    return rows;
}

/// What particle i sums, in order.
std::vector<std::uint32_t> rows_summed_by(const TriangleGroups& groups, std::uint32_t i) {
    const std::uint32_t group = i / group_lanes, lane = i % group_lanes;
    const std::uint32_t own = TriangleGroups::own_rows(group * group_lanes) + lane;
    std::vector<std::uint32_t> rows = {own, own + group_lanes};
    for (std::uint32_t k = groups.first_runs[group]; k < groups.first_runs[group + 1]; ++k)
        rows.push_back(groups.sum_runs[k] + lane);
    for (std::uint32_t k = groups.first_lists[group]; k < groups.first_lists[group + 1]; ++k)
        rows.push_back(row_at(groups.sum_lists[k * group_lanes + lane]));
    return rows;
}

bool is_flat(const Triangle& t) {
    return t[0] == t[1] && t[1] == t[2];
}

/// Beginning with the lowest corner.
Triangle turned(const Triangle& t) {
    const auto first = static_cast<std::size_t>(std::ranges::min_element(t) - t.begin());
    return {t[first], t[(first + 1) % 3], t[(first + 2) % 3]};
}

std::vector<NamedMesh> grouped_meshes() {
    std::vector<NamedMesh> all = sound_meshes();
    all.push_back({"whole groups", sheet(8, 32)});
    all.push_back({"many triangles at a particle", fan(40)});
    return all;
}

TEST(TriangleGroups, HoldEveryTriangleOnceWoundAsItWas) {
    for (const NamedMesh& named : grouped_meshes()) {
        SCOPED_TRACE(named.name);
        const ClothModel model = must(cook(named.mesh));
        std::map<Triangle, int> expected, found;
        for (const Triangle& t : model.triangles) ++expected[turned(t)];
        const TriangleGroups groups(model);
        for (const Triangle& t : triangles_in(groups))
            if (!is_flat(t)) ++found[turned(t)];
        EXPECT_EQ(found, expected);
    }
}

TEST(TriangleGroups, ParticlesSumTheirTrianglesOnceAndElseFlatOnes) {
    for (const NamedMesh& named : grouped_meshes()) {
        SCOPED_TRACE(named.name);
        const ClothModel model = must(cook(named.mesh));
        const TriangleGroups groups(model);
        const std::vector<Triangle> rows = triangles_in(groups);
        EXPECT_TRUE(is_flat(rows.back()));
        for (std::uint32_t i = 0; i < (model.particle_count + group_lanes - 1) / group_lanes * group_lanes;
             ++i) {
            std::vector<Triangle> found, expected;
            for (const std::uint32_t row : rows_summed_by(groups, i)) {
                ASSERT_LT(row, groups.rows);
                if (!is_flat(rows[row])) found.push_back(turned(rows[row]));
            }
            if (i < model.particle_count)
                for (std::uint32_t c = model.corner_offsets[i]; c < model.corner_offsets[i + 1]; ++c)
                    expected.push_back(turned(model.triangles[model.corner_triangles[c]]));
            std::ranges::sort(found);
            std::ranges::sort(expected);
            EXPECT_EQ(found, expected) << "particle " << i;
        }
    }
}

// What makes them worth their memory: hardly a row is empty, so no triangle is computed for nothing.
TEST(TriangleGroups, ShareTrianglesOutEvenly) {
    const ClothModel model = must(cook(loose_sheet(60, 70)));
    const TriangleGroups groups(model);
    // Where a window's particles lie in another order than its triangles, a few are left over.
    const std::uint32_t own =
        TriangleGroups::own_rows((model.particle_count + group_lanes - 1) / group_lanes * group_lanes);
    EXPECT_LE(groups.rows, own + own / 50);
}

}  // namespace
}  // namespace weft::test
