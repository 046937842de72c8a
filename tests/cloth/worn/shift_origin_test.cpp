// Far from the origin: cloth in a World whose origin is kept near it moves as it does at the origin.

#include <gtest/gtest.h>

#include "tests/cloth/worn/worn.h"

namespace weft::test::worn {
namespace {

/// A taut sheet that is swayed on a train; what it is in the train does not depend on where that is. Its
/// motion is damped: what folds shows every rounding before long, at the origin, too.
struct Train {
    explicit Train(float metres_a_step)
        : world(World::create(vacuum(downwards)).value()), pace(metres_a_step) {
        const Mesh mesh = make_sheet({.rows = 11,
                                      .columns = 10,
                                      .origin = {-0.3f, 0.6f, 0},
                                      .u = {0.6f, 0, 0},
                                      .v = {0, -0.55f, 0.05f}})
                              .value();
        ClothSettings settings;
        settings.frame_inertia = {0, 0, 0};
        settings.air_damping = 3;
        cloth = world.add_cloth(mesh, settings).value();
        for (std::uint32_t v = 0; v < 10; ++v) pins.push_back(v);
        EXPECT_TRUE(world.pin(cloth, pins));
        EXPECT_TRUE(world.set_frame(cloth, {}));
        rest.assign(mesh.positions.begin(), mesh.positions.begin() + 10);
    }
    void step() {
        // The camera follows whenever it is 16 m off.
        if (at - origin >= 16) {
            ASSERT_TRUE(world.shift_origin({static_cast<float>(at - origin), 0, 0}));
            origin = at;
        }
        at += static_cast<double>(pace);
        const auto x = static_cast<float>(at - origin);
        const float sway = 0.1f * std::sin(0.1f * static_cast<float>(++steps));
        ASSERT_TRUE(world.set_frame(cloth, {.translation = {x, 0, 0}}));
        std::vector<Vec3> targets = rest;
        for (Vec3& target : targets) target = {target.x + x, target.y, sway};
        ASSERT_TRUE(world.move_pins(cloth, pins, targets));
        EXPECT_FALSE(has(world.step(h).flags, StepFlags::state_restored));
    }

    World world;
    ClothId cloth;
    float pace;
    std::vector<std::uint32_t> pins;
    std::vector<Vec3> rest;
    double at = 0, origin = 0;  // [m], in the host's coordinates
    int steps = 0;
};

TEST(ShiftOrigin, AHundredKilometresOffClothMovesAsAtTheOrigin) {
    Train still(0), fast(8);
    fast.at = fast.origin = 1e5 - 8 * 120;
    for (int k = 0; k < 120; ++k) {
        still.step();
        fast.step();
        const RigidMotion place{.shift = {fast.at - fast.origin, 0, 0}};
        ASSERT_LT(farthest(places_of(still.world, still.cloth), place, places_of(fast.world, fast.cloth)),
                  3e-4f)
            << "after " << k + 1 << " steps";
    }
    EXPECT_NEAR(fast.at, 1e5, 1e-3);
}

// Everything at once, in the middle of a step's plans: pins that are told to move, colliders, gusts.
TEST(ShiftOrigin, ChangesNothingElse) {
    WorldSettings settings;
    settings.threads = 1;
    settings.wind.velocity = {1, 0, 3};
    settings.wind.gust = 0.5f;
    const auto make = [&](ClothId& cloth, ColliderId& ball) {
        World world = World::create(settings).value();
        cloth = world.add_cloth(hanging(9, 8)).value();
        EXPECT_TRUE(world.pin(cloth, std::vector<std::uint32_t>{0, 7}));
        ball = world.add_collider({.shape = Sphere{{0, 0.3f, 0.1f}, 0.15f}}).value();
        EXPECT_TRUE(world.add_collider({.shape = Plane{{0, 2, 0}, 0.05f}}));
        for (int k = 0; k < 30; ++k) world.step(h);
        EXPECT_TRUE(world.move_pin(cloth, 0, {-0.3f, 0.6f, 0.02f}));
        EXPECT_TRUE(world.move_collider(ball, {.shape = Sphere{{0.02f, 0.3f, 0.1f}, 0.15f}}));
        return world;
    };
    ClothId a, b;
    ColliderId ball;
    World still = make(a, ball), shifted = make(b, ball);
    const Vec3 to{16, 2, -8};
    ASSERT_TRUE(shifted.shift_origin(to));
    const RigidMotion place{.shift = -to_vector(to).cast<double>()};
    EXPECT_NEAR(std::get<Sphere>(shifted.collider(ball)->shape).center.x, -16, 1e-6f);
    for (int k = 0; k < 20; ++k) {
        EXPECT_LT(farthest(places_of(still, a), place, places_of(shifted, b)), 2e-4f) << "step " << k;
        still.step(h);
        shifted.step(h);
    }
}

TEST(ShiftOrigin, RefusesToLoseAnything) {
    World world = World::create(vacuum()).value();
    ASSERT_TRUE(world.add_cloth(sheet(4, 4)));
    const std::uint64_t before = world.state_hash();
    EXPECT_FALSE(world.shift_origin({0, std::nanf(""), 0}));
    const Result<void> far = world.shift_origin({1e5f, 0, 0});
    ASSERT_FALSE(far);
    EXPECT_NE(far.error().message.find("vertex 0 once moved"), std::string::npos) << far.error().message;
    ASSERT_TRUE(world.add_collider({.shape = Sphere{{-60000, 0, 0}, 1}}));
    EXPECT_FALSE(world.shift_origin({60000, 0, 0}));
    EXPECT_EQ(world.state_hash() == before, false);  // the collider is new
}

}  // namespace
}  // namespace weft::test::worn
