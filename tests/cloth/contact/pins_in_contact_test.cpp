// Cloth by contact that hangs from a pin, whose folds lie at the pin itself, and cloth that a pin draws
// through its own fold.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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

/// A sheet of 1 x 0.5 m, folded over, that hangs by four corners of its lower layer. The middle of the upper
/// layer is pinned.
struct Fold {
    Fold(std::uint32_t rows, std::uint32_t columns) : world(World::create({.threads = 1}).value()) {
        constexpr double pi = std::numbers::pi, apart = 0.05, bend = pi * apart / 2, leg = (1 - bend) / 2;
        Mesh mesh = make_sheet({.rows = rows, .columns = columns}).value();
        mesh.pattern.clear();
        for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
            const double u = static_cast<double>(i % columns) / (columns - 1),
                         v = 0.5 * (i / columns) / (rows - 1),
                         turned = std::clamp((u - leg) / bend, 0.0, 1.0) * pi,
                         x = u < leg          ? u
                             : u > leg + bend ? 1 - u
                                              : leg;
            mesh.pattern.push_back({static_cast<float>(u), static_cast<float>(v)});
            mesh.positions[i] = {static_cast<float>(x + apart / 2 * std::sin(turned)),
                                 static_cast<float>(1 + apart / 2 * (1 - std::cos(turned))),
                                 static_cast<float>(v - 0.25)};
        }
        ClothSettings settings;
        settings.self_collision = {.method = SelfCollisionMethod::contact};
        cloth = world.add_cloth(mesh, settings).value();
        const auto column = [&](double u) {
            return static_cast<std::uint32_t>(std::lround(u * (columns - 1)));
        };
        for (const std::uint32_t row : {0u, rows - 1})
            for (const std::uint32_t c : {0u, column(leg)}) EXPECT_TRUE(world.pin(cloth, row * columns + c));
        pulled = rows / 2 * columns + column(leg + bend + leg / 2);
        start = mesh.positions[pulled];
        EXPECT_TRUE(world.pin(cloth, pulled));
    }
    /// Pulls the pin down by up to this [m], at this speed [m/s] from 0.1 s on.
    void run(double speed, int steps, double most = 0.35) {
        for (int k = 1; k <= steps; ++k) {
            const double down = std::clamp(speed * (k / 60.0 - 0.1), 0.0, most);
            EXPECT_TRUE(
                world.move_pin(cloth, pulled, {start.x, start.y - static_cast<float>(down), start.z}));
            world.step(h);
            ASSERT_EQ(world.report().crossings, 0u) << "step " << k;
        }
        EXPECT_EQ(crossings(world, std::array{cloth}), 0);
    }

    World world;
    ClothId cloth;
    std::uint32_t pulled = 0;
    Vec3 start{};
};

// Where layers were squeezed till they touched, they were moved apart at the start of a step, through others:
// 299 and 462 pairs of triangles crossed.
TEST(PinsInContact, WhatIsYankedThroughItsOwnFoldCrossesNothing) {
    Fold(19, 37).run(11, 50);
    Fold(32, 63).run(20, 15);
}

// Contact's springs were too soft for strained cloth. Only the cut held it, every step asked for the same
// motion again, and all of the cloth trembled for as long as it was held: .1 m/s.
TEST(PinsInContact, WhatIsPulledIntoItsOwnFoldHangsStill) {
    Fold fold(31, 61);
    fold.run(5, 180, 0.25);
    double sum = 0;
    for (int k = 0; k < 60; ++k) {
        fold.world.step(h);
        sum += rms_speed(*fold.world.cloth(fold.cloth));
    }
    EXPECT_LT(sum / 60, 0.05);
}

}  // namespace
}  // namespace weft::test
