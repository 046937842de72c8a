#include "demo/scenes/measures.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/demo/small_world.h"

namespace weft::demo {
namespace {

TEST(Measures, GridsAreOfSquares) {
    for (const std::uint32_t particles : {100u, 4096u, 65536u}) {
        for (const float width : {0.1f, 1.0f, 1.5f}) {
            const GridSize grid = grid_size(particles, width, 1);
            EXPECT_NEAR(grid.rows * grid.columns, particles, 0.1 * particles);
            if (grid.columns < 8) continue;  // too few for a ratio
            const float ratio = static_cast<float>(grid.columns) / static_cast<float>(grid.rows);
            EXPECT_NEAR(ratio, width, 0.1f * width);
        }
    }
}

TEST(Measures, StretchOfAScaledSheetIsItsScale) {
    const SmallWorld small;
    const auto view = small.world.cloth(small.cloths.front().id);
    Mesh half = small.cloths.front().mesh;
    for (Vec3& p : half.positions) p = {0.5f * p.x, 0.8f * p.y, p.z};
    const Stretch stretch = structural_stretch(half, *view);
    EXPECT_NEAR(stretch.worst, 2, 1e-5);
    EXPECT_NEAR(stretch.mean, 0.5 * (2 + 1.25), 1e-5);
}

TEST(Measures, ClosestLayersAreThoseApartAtRest) {
    const SmallWorld small;
    const auto view = small.world.cloth(small.cloths.front().id);
    const Mesh& mesh = small.cloths.front().mesh;
    EXPECT_NEAR(closest_layers(mesh, *view, 0.05f), 0.1f, 1e-5);
    EXPECT_NEAR(closest_layers(mesh, *view, 0.15f), 0.2f, 1e-5);

    // A rest shape twice as large: what is 0.1 apart now was 0.2 apart there.
    Mesh wide = mesh;
    for (Vec3& p : wide.positions) p = {2 * p.x, 2 * p.y, p.z};
    EXPECT_NEAR(closest_layers(wide, *view, 0.15f), 0.1f, 1e-5);
}

TEST(Checks, NameWhatFailsWithItsValue) {
    Checks checks;
    checks.at_most("small", 1, 2);
    checks.at_least("large", 3, 2);
    EXPECT_TRUE(checks.result().ok());
    checks.at_most("height", 2.5f, 2);
    checks.at_least("width", 0.25f, 1);
    const auto result = checks.result();
    ASSERT_FALSE(result.ok());
    for (const char* part : {"height is 2.5", "at most 2", "width is 0.25", "at least 1"}) {
        EXPECT_NE(result.error().message.find(part), std::string::npos) << result.error().message;
    }
}

TEST(Checks, NotANumberMeetsNothing) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    Checks most, least;
    most.at_most("x", nan, 1);
    least.at_least("x", nan, 1);
    EXPECT_FALSE(most.result().ok());
    EXPECT_FALSE(least.result().ok());
}

TEST(Checks, APinIsHeldAndInItsPlace) {
    SmallWorld small;
    const ClothId cloth = small.cloths.front().id;
    ASSERT_TRUE(small.world.pin(cloth, 0).ok());
    small.world.step(1.0f / 60.0f);
    Checks good, moved, free;
    good.pinned_at(*small.world.cloth(cloth), 0, {0, 1, 0});
    moved.pinned_at(*small.world.cloth(cloth), 0, {0, 0.9f, 0});
    free.pinned_at(*small.world.cloth(cloth), 1, {0.1f, 1, 0});
    EXPECT_TRUE(good.result().ok()) << good.result().error().message;
    EXPECT_FALSE(moved.result().ok());
    EXPECT_FALSE(free.result().ok());
}

}  // namespace
}  // namespace weft::demo
