#include "demo/hands/project.h"

#include <gtest/gtest.h>

#include "tests/demo/small_world.h"

namespace weft::demo {
namespace {

TEST(Pick, MeetsTheClothWhereTheRayCrossesItsPlane) {
    const SmallWorld small;
    // From the front and from behind, at places all over the sheet but on no particle.
    for (float x = 0.03f; x < 1; x += 0.1f) {
        for (float y = 0.02f; y < 1; y += 0.1f) {
            const auto front = pointed_cloth(small.world, {{x, y, 2}, {0, 0, -1}});
            const auto back = pointed_cloth(small.world, {{x, y, -3}, {0, 0, 1}});
            ASSERT_TRUE(front && back) << x << ' ' << y;
            EXPECT_NEAR(front->distance, 2, 1e-5);
            EXPECT_NEAR(back->distance, 3, 1e-5);
            EXPECT_EQ(front->vertex, back->vertex);
            const Vec4 p = small.position(front->vertex);
            EXPECT_NEAR(p.x, x, 0.0501);
            EXPECT_NEAR(p.y, y, 0.0501);
        }
    }
}

TEST(Pick, MissesBesideAndBehind) {
    const SmallWorld small;
    EXPECT_FALSE(pointed_cloth(small.world, {{1.2f, 0.5f, 2}, {0, 0, -1}}));
    EXPECT_FALSE(pointed_cloth(small.world, {{0.5f, 0.5f, 2}, {0, 0, 1}}));
    EXPECT_FALSE(pointed_cloth(small.world, {{0.5f, 0.5f, 2}, {1, 0, 0}}));
}

}  // namespace
}  // namespace weft::demo
