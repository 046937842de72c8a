// Cloth that goes another way than it was going when groups were found crosses nothing of another group.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "crossing_count.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

constexpr float width = 0.3f;

/// An upright square across x.
Mesh upright(float x) {
    return must(
        make_sheet({.rows = 12, .columns = 12, .origin = {x, 0, 0}, .u = {0, width, 0}, .v = {0, 0, width}}));
}

/// A light sheet at rest beside a heavy one, and a wind from now on that blows one at the
/// other.
struct Gust {
    World world;
    std::vector<ClothId> cloths;

    Gust(float speed, float gap, bool light_first) : world(must(World::create(wind_of(speed)))) {
        for (const bool first : {true, false}) {
            const bool is_light = first == light_first;
            ClothSettings settings;
            settings.self_collision = {.enabled = true, .method = SelfCollisionMethod::contact};
            settings.fabric.areal_density = is_light ? 0.05f : 50.0f;
            cloths.push_back(must(world.add_cloth(upright(is_light ? 0 : gap), settings)));
        }
    }
    static WorldSettings wind_of(float speed) {
        WorldSettings settings;
        settings.gravity = {};
        settings.wind.velocity = {speed, 0, 0};
        return settings;
    }
};

// From rest the light sheet reaches its neighbour within a step: nothing told that the two would meet.
TEST(OwnSpace, ClothThatIsBlownAtAnotherCrossesNothing) {
    for (const float speed : {30.0f, 100.0f})
        for (const float gap : {0.03f, 0.1f, 0.3f})
            for (const bool light_first : {true, false}) {
                Gust scene(speed, gap, light_first);
                for (int k = 0; k < 8; ++k) {
                    scene.world.step(h);
                    ASSERT_EQ(crossings(scene.world, scene.cloths), 0)
                        << speed << " m/s, " << gap << " m apart, step " << k;
                }
                const Bounds light = must(scene.world.cloth(scene.cloths[light_first ? 0 : 1])).bounds;
                const Bounds heavy = must(scene.world.cloth(scene.cloths[light_first ? 1 : 0])).bounds;
                EXPECT_LT(light.lower.x, heavy.upper.x) << "it was to be stopped";
                EXPECT_GT(heavy.lower.x, gap) << "it was to be pushed";
                EXPECT_EQ(scene.world.report().restored_cloths, 0u);
            }
}

}  // namespace
}  // namespace weft::test
