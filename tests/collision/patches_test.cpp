#include "collision/search/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "tests/collision/contact/crumpled_sheet.h"

namespace weft::test {
namespace {

/// The square of a patch's diagonal.
float squared_diagonal(const Boxes& boxes, std::uint32_t k) {
    const float x = boxes.upper_x[k] - boxes.lower_x[k], y = boxes.upper_y[k] - boxes.lower_y[k],
                z = boxes.upper_z[k] - boxes.lower_z[k];
    return x * x + y * y + z * z;
}

TEST(Patches, AreSquaresOfAGridWhoseSidesAllowIt) {
    const Sheet sheet = crumpled_sheet(64);
    Patches patches(sheet.rest);
    Parallel parallel(1);
    patches.place(parallel, sheet.rest);
    const float side = 3.0f / 64;
    for (const Boxes& boxes : patches.view().patch_boxes)
        for (std::uint32_t k = 0; k < patches_per_block; ++k)
            EXPECT_NEAR(squared_diagonal(boxes, k), 2 * side * side, 1e-6f);
}

TEST(Patches, AreCompactInAGridWhoseSidesDoNot) {
    const Sheet sheet = crumpled_sheet(53);
    Patches patches(sheet.rest);
    Parallel parallel(1);
    patches.place(parallel, sheet.rest);
    for (std::uint32_t p = 0; p < 53 * 53 / patch_size; ++p)
        EXPECT_LT(squared_diagonal(patches.view().patch_boxes[p / 16], p % 16), 8 * 8.0f / (53 * 53)) << p;
}

TEST(Patches, EveryParticleIsInOneSlotAndItsBoxesHoldIt) {
    const Sheet sheet = crumpled_sheet(45);
    const auto n = static_cast<std::uint32_t>(sheet.positions.size());
    Patches patches(sheet.rest);
    Parallel parallel(3);
    patches.place(parallel, sheet.positions);
    const PatchesView view = patches.view();
    std::vector<std::uint32_t> particles(view.particles, view.particles + n);
    for (std::uint32_t slot = 0; slot < n; ++slot) {
        const Patch& patch = view.patches[slot / patch_size];
        const Vec4& p = sheet.positions[particles[slot]];
        EXPECT_EQ(patch.x[slot % patch_size], p.x);
        EXPECT_EQ(patch.y[slot % patch_size], p.y);
        EXPECT_EQ(patch.z[slot % patch_size], p.z);
        const std::uint32_t of_patch = slot / patch_size % 16, block = slot / block_size;
        for (const auto& [boxes, k] : {std::pair(view.patch_boxes[block], of_patch),
                                       std::pair(view.block_boxes[block / 16], block % 16),
                                       std::pair(view.region_boxes[block / 256], block / 16 % 16)}) {
            EXPECT_TRUE(boxes.lower_x[k] <= p.x && p.x <= boxes.upper_x[k]);
            EXPECT_TRUE(boxes.lower_y[k] <= p.y && p.y <= boxes.upper_y[k]);
            EXPECT_TRUE(boxes.lower_z[k] <= p.z && p.z <= boxes.upper_z[k]);
        }
    }
    for (std::uint32_t slot = n; slot < view.patches.size() * patch_size; ++slot)
        EXPECT_TRUE(std::isinf(view.patches[slot / patch_size].x[slot % patch_size]));
    std::ranges::sort(particles);
    for (std::uint32_t i = 0; i < n; ++i) EXPECT_EQ(particles[i], i);
    const Bounds expected = bounds_of(sheet.positions), bounds = patches.bounds();
    EXPECT_EQ(bounds.lower.y, expected.lower.y);
    EXPECT_EQ(bounds.upper.z, expected.upper.z);
}

TEST(Patches, WhatIsNotFiniteIsInNoBox) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                    inf = std::numeric_limits<float>::infinity();
    std::vector<Vec4> positions(300, Vec4{1, 2, 3, 1});
    Patches patches(positions);
    for (std::size_t i = 0; i < 300; i += 3) positions[i] = {nan, 2, 3, 1};
    for (std::size_t i = 1; i < 300; i += 3) positions[i] = {1, -inf, 3, 1};
    Parallel parallel(1);
    patches.place(parallel, positions);
    const Bounds bounds = patches.bounds();
    EXPECT_EQ(bounds.lower.x, 1);
    EXPECT_EQ(bounds.lower.y, 2);
    EXPECT_EQ(bounds.upper.y, 2);
    EXPECT_EQ(bounds.upper.z, 3);
}

}  // namespace
}  // namespace weft::test
