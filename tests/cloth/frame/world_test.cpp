// The World as a host meets it: several cloths, settings at run time, bad input, ids, and recovery.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string_view>

#include "tests/cloth/fixtures.h"

namespace weft::test {
namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

World make_world() {
    return World::create().value();
}

bool mentions(const Error& error, std::string_view text) {
    return error.message.find(text) != std::string::npos;
}

TEST(World, RefusesBadStepsWithoutTouchingTheState) {
    World world = make_world();
    ASSERT_TRUE(world.add_cloth(sheet(6, 6)).ok());
    world.step(h);
    const std::uint64_t before = world.state_hash();
    for (const float dt : {0.0f, -h, not_a_number, std::numeric_limits<float>::infinity(), 1.5f, 1e-38f,
                           std::numeric_limits<float>::denorm_min(), 0.99f * least_step}) {
        EXPECT_EQ(world.step(dt).flags, StepFlags::invalid_dt) << dt;
        EXPECT_EQ(world.state_hash(), before);
        EXPECT_EQ(world.report().step, 1u);
    }
}

TEST(World, TakesTheShortestStepByEveryMethodInManySubsteps) {
    for (const Method& method :
         {Method(Multilevel{}), Method(Jacobi{}), Method(Chebyshev{}), Method(ConjugateGradient{}),
          Method(Xpbd{}), Method(Fibres{}), Method(SymplecticEuler{})}) {
        SCOPED_TRACE(method.index());
        WorldSettings settings = vacuum({0, -9.81f, 0});
        settings.substeps = 16;
        World world = World::create(settings).value();
        ClothSettings cloth;
        cloth.method = method;
        cloth.substeps = 16;
        const ClothId id = world.add_cloth(sheet(6, 6), cloth).value();
        ASSERT_TRUE(world.pin(id, 0));
        ASSERT_TRUE(world.add_collider({.shape = Plane{{0, 1, 0}, -1}}));
        for (int k = 0; k < 100; ++k) EXPECT_EQ(world.step(least_step).flags, StepFlags::none);
        EXPECT_NEAR(world.cloth(id)->velocities[35].y, -9.81f * 100 * least_step, 1e-5f);
    }
}

TEST(World, StaleAndNullIdsAreReported) {
    World world = make_world();
    const ClothId first = world.add_cloth(sheet(4, 4)).value();
    ASSERT_TRUE(world.remove_cloth(first).ok());
    const ClothId second = world.add_cloth(sheet(5, 5)).value();
    EXPECT_EQ(second.index, first.index) << "the slot is used again, under another generation";
    for (const ClothId bad : {ClothId{}, first, ClothId{77, 1}}) {
        EXPECT_EQ(world.cloth(bad).error().code, ErrorCode::stale_id);
        EXPECT_EQ(world.remove_cloth(bad).error().code, ErrorCode::stale_id);
        EXPECT_EQ(world.pin(bad, 0).error().code, ErrorCode::stale_id);
        EXPECT_EQ(world.set_cloth_settings(bad, {}).error().code, ErrorCode::stale_id);
    }
    EXPECT_EQ(world.remove_collider({}).error().code, ErrorCode::stale_id);
    EXPECT_TRUE(world.cloth(second).ok());
}

TEST(World, RefusesPinsOfMissingVerticesAndMovesOfMissingPins) {
    World world = make_world();
    const ClothId id = world.add_cloth(sheet(4, 4)).value();
    EXPECT_TRUE(mentions(world.pin(id, 16).error(), "vertex 16"));
    EXPECT_TRUE(mentions(world.move_pin(id, 3, {0, 1, 0}).error(), "not pinned"));
    ASSERT_TRUE(world.pin(id, 3).ok());
    EXPECT_FALSE(world.move_pin(id, 3, {0, not_a_number, 0}).ok());
    EXPECT_FALSE(world.move_pin(id, 3, {0, 1e9f, 0}).ok());
    EXPECT_TRUE(world.move_pin(id, 3, {0, 1, 0}).ok());
}

TEST(World, MovesManyPinsAtOnceOrNone) {
    World world = World::create().value();
    const ClothId id = world.add_cloth(make_sheet({.rows = 4, .columns = 4}).value()).value();
    const std::vector<std::uint32_t> pins = {0, 3, 12};
    ASSERT_TRUE(world.pin(id, pins));
    const std::vector<Vec3> targets = {{0, 1, 0}, {0, 2, 0}, {0, 3, 0}};
    const auto heights = [&] {
        std::vector<float> result;
        const ClothView view = world.cloth(id).value();
        for (const std::uint32_t v : pins) result.push_back(view.positions[view.vertex_to_particle[v]].y);
        return result;
    };
    ASSERT_TRUE(world.move_pins(id, pins, targets));
    world.step(1.0f / 60);
    EXPECT_EQ(heights(), (std::vector<float>{1, 2, 3}));

    const std::uint64_t before = world.state_hash();
    const std::vector<std::uint32_t> one_is_free = {0, 12, 5}, one_is_not_there = {0, 3, 16};
    const std::vector<Vec3> one_is_nowhere = {{0, 5, 0}, {0, 5, 0}, {0, not_a_number, 0}};
    EXPECT_TRUE(mentions(world.move_pins(id, one_is_free, targets).error(), "vertex 5 is not pinned"));
    EXPECT_TRUE(mentions(world.move_pins(id, one_is_not_there, targets).error(), "vertex 16"));
    EXPECT_TRUE(mentions(world.move_pins(id, pins, one_is_nowhere).error(), "target"));
    EXPECT_TRUE(mentions(world.move_pins(id, pins, std::span(targets).first(2)).error(), "3 vertices and 2"));
    EXPECT_EQ(world.state_hash(), before);
    EXPECT_TRUE(world.move_pins(id, {}, {}));
}

TEST(World, RefusesBadCollidersAndChangesOfShape) {
    World world = make_world();
    EXPECT_FALSE(world.add_collider({.shape = Sphere{.center = {}, .radius = 0}}).ok());
    const ColliderId id = world.add_collider({.shape = Sphere{.center = {}, .radius = 0.2f}}).value();
    EXPECT_FALSE(world.move_collider(id, {.shape = Plane{}}).ok());
    EXPECT_FALSE(
        world.move_collider(id, {.shape = Sphere{.center = {not_a_number, 0, 0}, .radius = 0.2f}}).ok());
    EXPECT_TRUE(world.move_collider(id, {.shape = Sphere{.center = {0, 1, 0}, .radius = 0.2f}}).ok());
    world.step(h);
    EXPECT_EQ(std::get<Sphere>(world.collider(id)->shape).center.y, 1.0f);
}

TEST(World, NewClothsCanBeDrawnBeforeTheirFirstStep) {
    World world = make_world();
    const ClothId id = world.add_cloth(sheet(4, 4)).value();
    const ClothView cloth = world.cloth(id).value();
    for (const Vec4& n : cloth.normals) EXPECT_NEAR(n.y, 1, 1e-6f);
    EXPECT_NEAR(cloth.bounds.lower.x, -0.5f, 1e-6f);
    EXPECT_NEAR(cloth.bounds.upper.z, 0.5f, 1e-6f);
    EXPECT_EQ(cloth.positions[5].x, cloth.previous_positions[5].x);
}

TEST(World, PreviousPositionsAreTheStartOfTheStep) {
    for (const int substeps : {1, 2, 5}) {
        WorldSettings settings;
        settings.substeps = substeps;
        World world = World::create(settings).value();
        const ClothId id = world.add_cloth(sheet(9, 9)).value();
        ASSERT_TRUE(world.pin(id, 0).ok());
        for (int k = 0; k < 5; ++k) {
            const ClothView before = world.cloth(id).value();
            const std::vector<Vec4> start(before.positions.begin(), before.positions.end());
            world.step(h);
            const ClothView after = world.cloth(id).value();
            for (std::size_t i = 0; i < start.size(); ++i) {
                EXPECT_EQ(start[i].x, after.previous_positions[i].x);
                EXPECT_EQ(start[i].y, after.previous_positions[i].y);
                EXPECT_EQ(start[i].z, after.previous_positions[i].z);
            }
        }
    }
}

TEST(World, ClothsDoNotDisturbOneAnother) {
    World alone = make_world(), together = make_world();
    const ClothId a = alone.add_cloth(sheet(9, 9)).value();
    ASSERT_TRUE(alone.pin(a, 0).ok());
    const ClothId other = together.add_cloth(sheet(5, 30)).value();
    const ClothId b = together.add_cloth(sheet(9, 9)).value();
    ASSERT_TRUE(together.pin(b, 0).ok());
    for (int k = 0; k < 40; ++k) {
        alone.step(h);
        together.step(h);
        if (k == 20) {
            ASSERT_TRUE(together.remove_cloth(other).ok());
        }
    }
    const ClothView left = alone.cloth(a).value(), right = together.cloth(b).value();
    for (std::size_t i = 0; i < left.positions.size(); ++i) {
        EXPECT_EQ(left.positions[i].x, right.positions[i].x);
        EXPECT_EQ(left.positions[i].y, right.positions[i].y);
    }
    EXPECT_EQ(together.report().cloths, 1u);
}

TEST(World, SettingsTakeEffectWhileItRuns) {
    World world = make_world();
    const ClothId id = world.add_cloth(sheet(9, 9)).value();
    ASSERT_TRUE(world.pin(id, 0).ok());
    for (int k = 0; k < 10; ++k) world.step(h);

    WorldSettings settings = world.settings();
    settings.wind.velocity = {10, 0, 0};
    settings.threads = 2;
    ASSERT_TRUE(world.set_settings(settings).ok());
    const float light = world.cloth(id)->positions[40].w;
    ClothSettings cloth_settings = world.cloth_settings(id).value();
    cloth_settings.fabric.areal_density *= 4;
    cloth_settings.self_collision.method = SelfCollisionMethod::contact;
    ASSERT_TRUE(world.set_cloth_settings(id, cloth_settings).ok());
    EXPECT_FLOAT_EQ(world.cloth(id)->positions[40].w, light / 4);
    EXPECT_EQ(world.cloth(id)->positions[0].w, 0) << "a pin stays a pin";

    float x = 0;
    for (int k = 0; k < 60; ++k) world.step(h);
    for (const ClothView cloth = world.cloth(id).value(); const Vec4& position : cloth.positions)
        x += position.x;
    EXPECT_GT(x / 81, 0.0f) << "blown downwind of where it hung";
}

TEST(World, MassIsDensityTimesArea) {
    World world = make_world();
    const ClothId id = world.add_cloth(sheet(17, 9)).value();
    const ClothInfo info = world.cloth_info(id).value();
    EXPECT_NEAR(info.mass, 0.2f, 1e-6f);
    EXPECT_GT(info.bytes, 17u * 9u * 16u * 4u);
}

TEST(World, SaysBelowWhichBendingFoldsAreFinerThanTheMesh) {
    World world = World::create().value();
    ClothSettings settings;
    settings.fabric.areal_density = 0.3f;
    const auto least = [&](std::uint32_t per_side) {
        return world.measure_cloth(make_sheet({.rows = per_side, .columns = per_side}).value(), settings)
            .value()
            .least_bending;
    };
    // Cloth of so much bending is bent by its weight over two edges.
    const float coarse = least(33), fine = least(65);
    EXPECT_NEAR(std::cbrt(coarse / (0.3f * 9.81f)), 2.0f / 32, 1e-5f);
    EXPECT_NEAR(coarse / fine, 8, 1e-3f) << "half the edge, an eighth of the bending";
    settings.fabric.areal_density = 0.6f;
    EXPECT_NEAR(least(65) / fine, 2, 1e-3f);
}

TEST(Guard, RestoresAClothThatRanAway) {
    // Out of the world at ten kilometres a second: the guard must keep the last sound state and say so.
    World world = make_world();
    const ClothId id = world.add_cloth(sheet(6, 6)).value();
    for (int k = 0; k < 5; ++k) world.step(h);
    const WorldSettings sane = world.settings();
    WorldSettings settings = sane;
    settings.gravity = {0, -1e4f, 0};
    settings.max_speed = 1e4f;
    settings.wind.air_density = 0;
    ASSERT_TRUE(world.set_settings(settings).ok());
    Vec4 sound;
    StepReport report;
    for (int k = 0; k < 20 && !has(report.flags, StepFlags::state_restored); ++k) {
        sound = world.cloth(id)->positions[7];
        report = world.step(1);
    }
    EXPECT_LT(sound.y, -5e4f) << "it ran away before it was stopped";
    EXPECT_TRUE(has(report.flags, StepFlags::state_restored));
    EXPECT_EQ(report.restored_cloths, 1u);
    EXPECT_EQ(world.cloth(id)->positions[7].y, sound.y);
    EXPECT_EQ(world.cloth(id)->velocities[7].y, 0);

    ASSERT_TRUE(world.set_settings(sane).ok());
    for (int k = 0; k < 120; ++k) EXPECT_FALSE(has(world.step(h).flags, StepFlags::state_restored));
    float fall = 0;
    for (const Vec4& v : world.cloth(id)->velocities) fall += v.y / 36;
    EXPECT_LT(fall, -1) << "it falls on";
}

TEST(Guard, SpeedIsLimitedAndSaysSo) {
    World world = make_world();
    WorldSettings settings = world.settings();
    settings.max_speed = 0.5f;
    ASSERT_TRUE(world.set_settings(settings).ok());
    ASSERT_TRUE(world.add_cloth(sheet(6, 6)).ok());
    StepFlags last = StepFlags::none;
    for (int k = 0; k < 20; ++k) last = world.step(h).flags;
    EXPECT_TRUE(has(last, StepFlags::speed_limited));
    EXPECT_NEAR(world.report().peak_speed, 0.5f, 1e-4f);
}

TEST(Guard, APinThatJumpsAHundredMetresIsSurvived) {
    World world = make_world();
    ClothSettings settings;
    settings.self_collision.method = SelfCollisionMethod::contact;
    const ClothId id = world.add_cloth(sheet(16, 16), settings).value();
    for (const std::uint32_t corner : {0u, 15u}) ASSERT_TRUE(world.pin(id, corner).ok());
    ASSERT_TRUE(world.move_pin(id, 0, {100, 0, 0}).ok());
    for (int k = 0; k < 3; ++k) world.step(h);
    ASSERT_TRUE(world.move_pin(id, 0, {-0.5f, 0, -0.5f}).ok());
    for (int k = 0; k < 240; ++k) world.step(h);
    const Bounds bounds = world.cloth(id)->bounds;
    EXPECT_LT(bounds.upper.x - bounds.lower.x, 2.5f);
    EXPECT_LT(world.report().peak_speed, 20.0f);
}

TEST(Profile, StagesAddUpToTheStep) {
    World world = make_world();
    ClothSettings settings;
    settings.self_collision.method = SelfCollisionMethod::contact;
    ASSERT_TRUE(world.add_cloth(sheet(64, 64), settings).ok());
    ASSERT_TRUE(world.add_collider({.shape = Plane{.normal = {0, 1, 0}, .offset = -1}}).ok());
    for (int k = 0; k < 20; ++k) world.step(h);
    const std::span<const StageTime> stages = world.profile();
    float sum = 0, in_cloths = 0, parts = 0, whole = 0;  // parts: of the last stage seen that has some
    for (const StageTime& stage : stages.first(stages.size() - 1)) {
        const bool used = std::string_view(stage.name) != "limits";
        EXPECT_EQ(stage.last > 0, used) << stage.name << ": a stage takes time if the scene has use for it";
        if (stage.depth == 1) sum += stage.last;
        if (stage.depth == 2) in_cloths += stage.last;
        parts = stage.depth == 3 ? parts + stage.last : 0;
        whole = stage.depth == 3 ? whole : stage.last;
        EXPECT_LE(parts, whole * 1.001f) << stage.name;
    }
    EXPECT_LE(in_cloths, sum * 1.001f);
    EXPECT_STREQ(stages.back().name, "step");
    EXPECT_LE(sum, stages.back().last * 1.001f) << "stages do not overlap";
    EXPECT_EQ(world.report().milliseconds, stages.back().last);
}

}  // namespace
}  // namespace weft::test
