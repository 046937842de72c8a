// Neighbours read from windows against neighbours read from memory.

#include "cloth/implicit/row_windows.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "as_for_threads.h"
#include "fixtures.h"
#include "meshes.h"
#include "spring_scene.h"

namespace weft::test {
namespace {

constexpr int too_many_threads = 256;  // for tiles of any size: all is read from memory

struct Results {
    std::vector<Vec4> b, product, remainder, relaxed, residual;
    Products products;
};

std::vector<Vec4> values(const AlignedBuffer<Vec4>& rows) {
    return {rows.data(), rows.data() + (rows.size() + 15) / 16 * 16};
}

Results everything(const SpringScene& scene, Parallel& parallel) {
    SpringSystem system(scene.model);
    system.linearise(parallel, scene.equation(), scene.velocities.span(), scene.about);
    const std::span<const Vec4> b = system.right_side().span(), x = scene.velocities.span();
    AlignedBuffer<Vec4> out(scene.size());
    Results results;
    results.b = values(system.right_side());
    results.products = system.multiply(parallel, b, x, out.span());
    results.product = values(out);
    system.subtract_product(parallel, b, x, out.span());
    results.remainder = values(out);
    system.relax(parallel, b, x, {.step = 0.75f}, out.span());
    results.relaxed = values(out);
    system.residual(parallel, scene.equation(), x, out.span());
    results.residual = values(out);
    return results;
}

bool same_bytes(const std::vector<Vec4>& a, const std::vector<Vec4>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec4)) == 0;
}

struct Size {
    std::uint32_t rows, columns;
};
constexpr Size sizes[] = {{16, 16}, {20, 20}, {40, 25}, {48, 48}, {64, 100}, {128, 128}, {1000, 5}, {7, 333}};

TEST(RowWindows, GiveTheSameBytesAsMemory) {
    for (const auto& [rows, columns] : sizes) {
        for (const LinearisedAbout about : {LinearisedAbout::base, LinearisedAbout::iterate}) {
            SCOPED_TRACE(testing::Message() << rows << " x " << columns);
            const SpringScene scene = make_scene(sheet(rows, columns), 400, about);
            Parallel memory = as_for_threads(too_many_threads);
            const Results expected = everything(scene, memory);
            const RowWindows windows(SpringSystem(scene.model).stencil());
            ASSERT_EQ(windows.tiles(scene.size(), too_many_threads), 0u);
            ASSERT_GT(windows.tiles(scene.size(), 1), 0u);
            for (const int threads : {1, 2, 3, 5}) {
                Parallel parallel = as_for_threads(threads);
                const Results results = everything(scene, parallel);
                EXPECT_TRUE(same_bytes(results.b, expected.b)) << threads;
                EXPECT_TRUE(same_bytes(results.product, expected.product)) << threads;
                EXPECT_TRUE(same_bytes(results.remainder, expected.remainder)) << threads;
                EXPECT_TRUE(same_bytes(results.relaxed, expected.relaxed)) << threads;
                EXPECT_TRUE(same_bytes(results.residual, expected.residual)) << threads;
                EXPECT_EQ(results.products.b_x, expected.products.b_x) << threads;
                EXPECT_EQ(results.products.x_x, expected.products.x_x) << threads;
                EXPECT_EQ(results.products.x_wx, expected.products.x_wx) << threads;
            }
        }
    }
}

TEST(RowWindows, AreForGridsAlone) {
    const CookedCloth grid = must(cook(sheet(30, 45))), mesh = must(cook(loose_sheet(30, 45)));
    EXPECT_GT(RowWindows(SpringSystem(grid).stencil()).bytes(), 0u);
    EXPECT_EQ(RowWindows(SpringSystem(mesh).stencil()).bytes(), 0u);
}

// However many threads there are: two a tile, and tiles of four reaches.
TEST(RowWindows, TakeNoMoreThanTwentyBytesARowOfALargeGrid) {
    for (const std::uint32_t side : {64u, 128u, 256u}) {
        const CookedCloth grid = must(cook(sheet(side, side)));
        EXPECT_LT(RowWindows(SpringSystem(grid).stencil()).bytes(), std::size_t{20} * grid.particle_count);
    }
}

}  // namespace
}  // namespace weft::test
