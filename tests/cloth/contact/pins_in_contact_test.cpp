// Cloth by contact that hangs from a pin, whose folds lie at the pin itself.

#include <gtest/gtest.h>

#include <algorithm>

#include "crossing_count.h"
#include "tests/cloth/fixtures.h"
#include "weft/weft.h"

namespace weft::test {
namespace {

/// A square of 20 x 20 cells that hangs by a corner.
struct Tag {
    static constexpr std::uint32_t side = 21;

    Tag(const Method& method, int substeps, float cell) : world(World::create({.threads = 1}).value()) {
        const float length = cell * (side - 1);
        const Mesh mesh =
            make_sheet(
                {.rows = side, .columns = side, .origin = {}, .u = {length, 0, 0}, .v = {0, 0, length}})
                .value();
        ClothSettings settings;
        settings.method = method;
        settings.substeps = substeps;
        settings.thickness = 0.3f * cell;
        settings.self_collision = {.method = SelfCollisionMethod::contact};
        cloth = world.add_cloth(mesh, settings).value();
        EXPECT_TRUE(world.pin(cloth, 0));
    }

    World world;
    ClothId cloth;
};

// The motion that cloth has in common drew it off, by ten centimetres within half a second, at 100 m/s.
TEST(PinsInContact, APinThatNobodyMovesStaysWhereItIs) {
    for (const float cell : {0.002f, 0.005f})
        for (const auto& [method, substeps] :
             {std::pair(Method(Xpbd{}), 8), {Method(Fibres{}), 4}, {Method(Multilevel{}), 1}}) {
            Tag tag(method, substeps, cell);
            float fastest = 0;
            for (int k = 0; k < 60; ++k) {
                const StepReport& report = tag.world.step(h);
                fastest = std::max(fastest, report.peak_speed);
                const Vec4 pin = tag.world.cloth(tag.cloth)->positions[0];
                ASSERT_TRUE(pin.x == 0 && pin.y == 0 && pin.z == 0) << method.index() << " step " << k;
                ASSERT_EQ(report.pin_lag, 0) << method.index() << " step " << k;
                ASSERT_EQ(report.crossings, 0u) << method.index() << " step " << k;
            }
            EXPECT_LT(fastest, 8) << method.index() << " " << cell;
            EXPECT_EQ(crossings(tag.world, std::array{tag.cloth}), 0) << method.index() << " " << cell;
        }
}

}  // namespace
}  // namespace weft::test
