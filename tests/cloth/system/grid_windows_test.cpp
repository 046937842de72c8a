// Loops over a grid's rows, however they are cut into tiles. What they give is tested with those of other
// meshes.

#include "cloth/equation/grid/grid_windows.h"

#include <gtest/gtest.h>

#include <vector>

#include "spring_scene.h"
#include "tests/cloth/as_for_threads.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

struct WindowResults {
    std::vector<Vec4> b, product, remainder, corrected, relaxed, residual;
    Products products;
};

template <class Rows>
std::vector<Vec4> values(const Rows& rows) {
    return {rows.data(), rows.data() + (rows.size() + 15) / 16 * 16};
}

WindowResults all_of_windows(const SpringScene& scene, Parallel& parallel) {
    SpringSystem system(scene.model);
    system.linearise(parallel, scene.equation(), scene.velocities.span(), scene.about);
    const std::span<const Vec4> b = system.right_side().span(), x = scene.velocities.span();
    AlignedBuffer<Vec4> out(scene.size());
    WindowResults results;
    results.b = values(system.right_side());
    results.products = system.multiply(parallel, {b.data(), x.data()}, x, out.span());
    results.product = values(out);
    const Interpolation p = random_interpolation(scene, 9);
    const AlignedBuffer<Vec4> coarse = random_rows(9, 1, 5);
    AlignedBuffer<Vec4> first(scene.size());
    system.subtract_first_step(parallel, b, 0.75f, first.span(), out.span());
    results.remainder = values(out);
    system.relax_corrected(parallel, b, 0.75f, first.span(), {p, coarse.span()}, out.span());
    results.corrected = values(out);
    system.relax(parallel, b, x, {.step = 0.75f}, out.span());
    results.relaxed = values(out);
    system.residual(parallel, scene.equation(), x, out.span());
    results.residual = values(out);
    return results;
}

struct Size {
    std::uint32_t rows, columns;
};
constexpr Size sizes[] = {{16, 16}, {20, 20}, {40, 25}, {48, 48}, {64, 100}, {128, 128}, {1000, 5}, {7, 333}};

TEST(GridWindows, GiveTheSameBytesInAnyTiles) {
    for (const auto& [rows, columns] : sizes) {
        for (const LinearisedAbout about : {LinearisedAbout::base, LinearisedAbout::iterate}) {
            SCOPED_TRACE(testing::Message() << rows << " x " << columns);
            const SpringScene scene = make_scene(sheet(rows, columns), 400, about);
            Parallel serial(1);
            const WindowResults expected = all_of_windows(scene, serial);
            for (const int threads : {2, 3, 5, 256}) {
                Parallel parallel = as_for_threads(threads);
                const WindowResults results = all_of_windows(scene, parallel);
                EXPECT_TRUE(same_bytes(results.b, expected.b)) << threads;
                EXPECT_TRUE(same_bytes(results.product, expected.product)) << threads;
                EXPECT_TRUE(same_bytes(results.remainder, expected.remainder)) << threads;
                EXPECT_TRUE(same_bytes(results.corrected, expected.corrected)) << threads;
                EXPECT_TRUE(same_bytes(results.relaxed, expected.relaxed)) << threads;
                EXPECT_TRUE(same_bytes(results.residual, expected.residual)) << threads;
                EXPECT_EQ(results.products.dots, expected.products.dots) << threads;
                EXPECT_EQ(results.products.x_wx, expected.products.x_wx) << threads;
            }
        }
    }
}

}  // namespace
}  // namespace weft::test
