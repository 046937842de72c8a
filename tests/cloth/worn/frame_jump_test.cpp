// A frame that jumps takes its cloth along: it moves on in the new place as it would have in the old one.

#include <gtest/gtest.h>

#include <numbers>

#include "tests/cloth/worn/worn.h"

namespace weft::test::worn {
namespace {

/// A sheet on a runner: two pins and a capsule go with its frame, and the ground stays.
struct Runner {
    explicit Runner(const ClothSettings& of) : world(World::create(vacuum(downwards)).value()) {
        cloth = world.add_cloth(hanging(9, 8), of).value();
        EXPECT_TRUE(world.pin(cloth, std::vector<std::uint32_t>{0, 7}));
        limb = world.add_collider(limb_at({})).value();
        EXPECT_TRUE(world.add_collider({.shape = Box{{0, -0.4f, 0}, {}, {50, 0.3f, 50}}}).ok());
        EXPECT_TRUE(world.set_frame(cloth, {}));
    }
    [[nodiscard]] static Collider limb_at(const RigidMotion& place) {
        return {
            .shape = Capsule{place.point(Vec3{-0.2f, 0.3f, 0.1f}), place.point(Vec3{0.2f, 0.3f, 0.1f}), 0.1f},
            .friction = 0.5f};
    }
    /// Takes a step with everything on the runner at a pose.
    void step(const Transform& to) {
        const RigidMotion place = rigid_motion(to);
        EXPECT_TRUE(world.set_frame(cloth, to));
        EXPECT_TRUE(world.move_collider(limb, limb_at(place)));
        for (const std::uint32_t v : {0u, 7u})
            EXPECT_TRUE(world.move_pin(cloth, v, place.point(Vec3{v == 0 ? -0.3f : 0.3f, 0.6f, 0})));
        const StepReport& report = world.step(h);
        EXPECT_FALSE(has(report.flags, StepFlags::state_restored));
        peak_speed = std::max(peak_speed, report.peak_speed);
    }

    World world;
    ClothId cloth;
    ColliderId limb;
    float peak_speed = 0;
};

/// A run of 3 m/s forwards.
Transform run(int step) {
    return {.translation = {0, 0, 3 * h * static_cast<float>(step)}};
}
/// The same run, from step 31 on in another place and another way round.
Transform run_with_jump(int step, const Transform& jump) {
    return step <= 30 ? run(step) : moved(run(step), rigid_motion(jump));
}

ClothSettings teleported(const FrameInertia& inertia) {
    ClothSettings settings;
    settings.frame_inertia = inertia;
    settings.teleport_distance = 1;
    settings.teleport_angle = 1;
    return settings;
}

// The turn is about the vertical, along which gravity is. Twelve steps: later what folds shows every
// rounding.
TEST(FrameJump, GoesOnAsItWouldHave) {
    for (const FrameInertia& inertia :
         {FrameInertia{}, FrameInertia{0, 0, 0}, FrameInertia{0.4f, 0.4f, 0.4f}})
        for (const Transform& jump :
             {Transform{.translation = {7, 0, -5}},
              Transform{.translation = {1.2f, 0, 0}, .rotation = turn({0, 1, 0}, 2.5)},
              Transform{.rotation = turn({0, 1, 0}, std::numbers::pi / 2)}}) {
            SCOPED_TRACE(testing::Message() << "inertia " << inertia.linear << ", to " << jump.translation.x);
            Runner still(teleported(inertia)), jumped(teleported(inertia));
            for (int k = 1; k <= 42; ++k) {
                still.step(run(k));
                jumped.step(run_with_jump(k, jump));
                EXPECT_LT(
                    farthest(places_of(still.world, still.cloth), k > 30 ? rigid_motion(jump) : RigidMotion{},
                             places_of(jumped.world, jumped.cloth)),
                    8e-3f)
                    << "step " << k;
                if (k != 31) continue;
                const ClothView view = *jumped.world.cloth(jumped.cloth);
                for (std::size_t i = 0; i < view.positions.size(); ++i)
                    EXPECT_LT((xyz(view.positions[i]) - xyz(view.previous_positions[i])).norm(), 0.2f)
                        << "a blend shows no path";
            }
            EXPECT_LT(jumped.peak_speed, 1.3f * still.peak_speed);
        }
}

TEST(FrameJump, SweepsTheClothThroughTheWorldWithoutTheSetting) {
    Runner runner({});
    for (int k = 1; k <= 31; ++k) runner.step(run_with_jump(k, {.translation = {1.5f, 0, -1}}));
    EXPECT_GT(runner.peak_speed, 50);
}

TEST(FrameJump, IsNoneWhereTheFrameStaysBelowBothLimits) {
    ClothSettings with = teleported({0.5f, 0.5f, 0.5f}), without = with;
    without.teleport_distance = without.teleport_angle = 0;
    Runner one(with), other(without);
    for (int k = 1; k <= 20; ++k) {
        const Transform pose{.translation = {0.5f * static_cast<float>(k % 2), 0, 0},
                             .rotation = turn({0, 1, 0}, 0.9 * (k % 2))};
        one.step(pose);
        other.step(pose);
    }
    EXPECT_EQ(one.world.state_hash(), other.world.state_hash());
}

// Pins and a skin go along where the host leaves them alone.
TEST(FrameJump, TakesAlongWhatTheHostHasNotMoved) {
    World world = World::create(vacuum({})).value();
    const Mesh mesh = hanging(8, 8);
    ClothSettings settings = teleported({});
    const ClothId cloth = world.add_cloth(mesh, settings).value();
    ASSERT_TRUE(world.pin(cloth, std::vector<std::uint32_t>{0, 7}));
    ASSERT_TRUE(world.set_map(cloth, Map::leash, std::vector<float>(mesh.positions.size(), 0.05f)));
    ASSERT_TRUE(world.set_skin(cloth, mesh.positions, {}));
    ASSERT_TRUE(world.set_frame(cloth, {}));
    world.step(h);
    const Transform to{.translation = {30, 2, 0}, .rotation = turn({1, 1, 0}, 2)};
    ASSERT_TRUE(world.set_frame(cloth, to));
    for (int k = 0; k < 3; ++k) {
        world.step(h);
        EXPECT_LT(world.report().peak_speed, 0.01f);
        EXPECT_EQ(world.report().limits_exceeded, 0u);
    }
    const std::vector<Vector3> there = places_of(world, cloth);
    const ClothView view = *world.cloth(cloth);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        EXPECT_LT(
            (there[view.vertex_to_particle[v]] - rigid_motion(to).point(to_vector(mesh.positions[v]))).norm(),
            1e-3f);
}

TEST(FrameJump, OutOfReachStopsTheCloth) {
    World world = World::create(vacuum({})).value();
    const ClothId cloth = world.add_cloth(hanging(8, 8), teleported({})).value();
    ASSERT_TRUE(world.set_frame(cloth, {.translation = {-5, 0, 0}}));
    world.step(h);
    ASSERT_TRUE(world.set_frame(cloth, {.translation = {99999, 0, 0}}));
    EXPECT_TRUE(has(world.step(h).flags, StepFlags::state_restored));
    EXPECT_LT(world.cloth(cloth)->bounds.upper.x, 1);
}

}  // namespace
}  // namespace weft::test::worn
