// The multilevel solver against dense algebra and its own promises.

#include "cloth/solver/passes/multilevel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/cloth/air/waving.h"
#include "tests/cloth/system/dense_algebra.h"

namespace weft::test {
namespace {

/// One step by the multilevel solver from a cloth's state.
Eigen::VectorXd stepped(Cloth& cloth, const Multilevel& method, int threads = 1) {
    cloth.settings.method = method;
    Parallel parallel(threads);
    Profiler profiler(stage_names);
    MultilevelSolver solver(cloth.model, cloth.settings, cloth.state.positions.span());
    solver.lay_out_alone();
    const StepEquation equation = equation_of(cloth, h);
    solver.solve({.parallel = parallel,
                  .profiler = profiler,
                  .model = cloth.model,
                  .settings = cloth.settings,
                  .equation = equation,
                  .velocities = cloth.scratch_velocities.span()});
    return velocity_change(cloth);
}

// Galerkin's condition: b - W dv is orthogonal to the velocity, and so does no work, though little of the
// equation is solved.
TEST(MultilevelSolver, WhatOnePassLeavesDoesNoWork) {
    const std::uint32_t corners[] = {0, 11};
    Cloth cloth = waving(sheet(12, 12), corners);
    const Levels levels(cloth);
    const DenseSystem system = dense(*levels.system);
    const Eigen::VectorXd dv = stepped(cloth, {.passes = 1, .tolerance = 1e6f});
    Eigen::VectorXd velocities = flat(cloth.scratch_velocities.span());
    for (const std::uint32_t pinned : corners) velocities.segment<3>(3 * pinned).setZero();
    const Eigen::VectorXd left = system.right_side - system.matrix * dv;
    const Eigen::VectorXd exact = solution(system.matrix, system.right_side);
    EXPECT_GT((dv - exact).norm(), 0.01 * exact.norm()) << "solved so far that this is no test";
    EXPECT_LT(std::abs(left.dot(velocities)), 1e-3 * std::abs(system.right_side.dot(velocities)));
}

// Still cloth that is let go has no motion that its error could be small beside: a pass has further cycles,
// which are steps of conjugate gradients.
TEST(MultilevelSolver, FurtherCyclesSolveTheStepOfStillCloth) {
    const std::uint32_t corners[] = {0, 11};
    Cloth cloth = waving(sheet(12, 12), corners);
    for (Vec4& v : cloth.state.velocities.span()) v = {};
    const Levels levels(cloth);
    const DenseSystem system = dense(*levels.system);
    const Eigen::VectorXd dv = stepped(cloth, {.passes = 1, .tolerance = 1e6f});
    const Eigen::VectorXd exact = solution(system.matrix, system.right_side);
    const auto energy = [&](const Eigen::VectorXd& x) { return x.dot(system.matrix * x); };
    EXPECT_LT(energy(dv - exact), 1e-3 * energy(exact));
    const Eigen::VectorXd left = system.right_side - system.matrix * dv;
    EXPECT_LT(std::abs(left.dot(dv)), 1e-3 * energy(exact)) << "does no work";
}

/// What the velocities leave of the nonlinear equation, relative to what inertia alone leaves.
double equation_left(const Cloth& cloth, const Eigen::VectorXd& dv) {
    Parallel serial(1);
    const auto system = make_system(cloth.model, cloth.settings);
    AlignedBuffer<Vec4> velocities(cloth.model.particle_count), left(cloth.model.particle_count);
    const auto residual = [&](double factor) {
        for (std::uint32_t i = 0; i < velocities.size(); ++i) {
            const Eigen::Vector3d change = factor * dv.segment<3>(3 * i);
            velocities[i] = to_vec4(xyz(cloth.state.velocities[i]) + change.cast<float>(), 0);
        }
        system->residual(serial, equation_of(cloth, h), velocities.span(), left.span());
        return flat(left.span()).norm();
    };
    return residual(1) / residual(0);
}

/// In tension everywhere, where W is the equation's true derivative.
Cloth stretched() {
    const std::uint32_t corners[] = {0, 19};
    Cloth cloth = waving(sheet(20, 20), corners);
    for (Vec4& x : cloth.state.positions.span()) set_xyz(x, 1.1f * xyz(x));
    return cloth;
}

TEST(MultilevelSolver, ManyPassesSolveTheNonlinearStep) {
    Cloth cloth = stretched();
    const double one = equation_left(cloth, stepped(cloth, {.passes = 1, .tolerance = 1e6f}));
    const double many = equation_left(cloth, stepped(cloth, {.passes = 60}));
    EXPECT_GT(one, 10 * many);
    EXPECT_LT(many, 1e-3);
}

WorldSettings still_world() {
    WorldSettings settings;
    settings.wind.air_density = 0;
    return settings;
}

TEST(MultilevelSolver, FollowsPinsThatComeAndGo) {
    ClothSettings settings = stiff();
    settings.method = Multilevel{};
    World world = World::create(still_world()).value();
    const ClothId id = world.add_cloth(sheet(24, 24), settings).value();
    ASSERT_TRUE(world.pin(id, 0).ok());
    ASSERT_TRUE(world.pin(id, 23).ok());
    for (int k = 0; k < 60; ++k) world.step(h);
    EXPECT_GT(world.cloth(id)->bounds.upper.y, -0.05f);
    ASSERT_TRUE(world.unpin(id, 0).ok());
    ASSERT_TRUE(world.pin(id, 300).ok());
    for (int k = 0; k < 60; ++k) world.step(h);
    const ClothView held = world.cloth(id).value();
    EXPECT_LT(held.positions[0].y, -0.3f) << "let go";
    EXPECT_EQ(xyz(held.positions[300]), xyz(held.previous_positions[300])) << "held";
    ASSERT_TRUE(world.unpin(id, 23).ok());
    ASSERT_TRUE(world.unpin(id, 300).ok());
    const auto fall_speed = [&] {
        double mass = 0, momentum = 0;
        const ClothView cloth = world.cloth(id).value();
        for (std::size_t i = 0; i < cloth.positions.size(); ++i) {
            const double m = 1 / static_cast<double>(cloth.positions[i].w);
            mass += m;
            momentum -= m * static_cast<double>(cloth.velocities[i].y);
        }
        return momentum / mass;
    };
    const double before = fall_speed(), seconds = 30 * static_cast<double>(h);
    for (int k = 0; k < 30; ++k) world.step(h);
    const double rate = static_cast<double>(settings.air_damping), kept = std::exp(-rate * seconds);
    EXPECT_NEAR(fall_speed(), before * kept + 9.81 / rate * (1 - kept), 0.2) << "falls freely";
    EXPECT_EQ(world.report().flags, StepFlags::none);
}

/// Positions of `count` quads that hang by a corner each, after half a second.
std::vector<Vector3> swung(std::uint32_t count) {
    ClothSettings settings = stiff();
    settings.method = Multilevel{};
    World world = World::create(still_world()).value();
    const ClothId id = world.add_cloth(many(loose_sheet(2, 2), count), settings).value();
    for (std::uint32_t k = 0; k < count; ++k) EXPECT_TRUE(world.pin(id, 4 * k));
    for (int k = 0; k < 30; ++k) world.step(h);
    EXPECT_EQ(world.report().flags, StepFlags::none);
    std::vector<Vector3> result;
    const ClothView view = world.cloth(id).value();
    for (const Vec4& x : view.positions) result.push_back(xyz(x));
    return result;
}

TEST(MultilevelSolver, MovesEachOfManyPiecesAsItWouldAlone) {
    const std::vector<Vector3> alone = swung(1);
    EXPECT_GT((alone[3] - Vector3(alone[3].x(), 0, alone[3].z())).norm(), 0.1f) << "it swings";
    for (const std::uint32_t count : {2u, 200u, 1000u, 5000u}) {
        const std::vector<Vector3> all = swung(count);
        float farthest = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Vector3 offset(2.0f * static_cast<float>(i / 4), 0, 0);
            farthest = std::max(farthest, (all[i] - offset - alone[i % 4]).norm());
        }
        // Coordinates of up to 2 count metres are rounded.
        EXPECT_LT(farthest, 1e-4f + 1e-5f * static_cast<float>(count)) << count;
    }
}

TEST(MultilevelSolver, TheSameSettingsGiveTheSameStepAfterAnyHistory) {
    const auto settings_of = [](float shear, float bending) {
        ClothSettings settings = stiff();
        settings.method = Multilevel{};
        settings.fabric.shear = shear;
        settings.fabric.bending = bending;
        return settings;
    };
    const std::uint32_t corners[] = {0, 19};
    const auto step_after = [&](std::initializer_list<ClothSettings> history) {
        Cloth cloth = waving(sheet(20, 20), corners, *history.begin());
        Profiler profiler(stage_names);
        Parallel serial(1);
        for (const ClothSettings& settings : history) {
            cloth.apply(settings);
            const StepEquation equation = equation_of(cloth, h);
            cloth.solver->lay_out_alone();
            cloth.solver->solve({.parallel = serial,
                                 .profiler = profiler,
                                 .model = cloth.model,
                                 .settings = cloth.settings,
                                 .equation = equation,
                                 .velocities = cloth.scratch_velocities.span()});
        }
        return flat(cloth.scratch_velocities.span());
    };
    const ClothSettings last = settings_of(50, 2e-5f);
    const Eigen::VectorXd expected = step_after({last});
    for (const ClothSettings& before : {settings_of(1, 2e-5f), settings_of(800, 1e-2f), settings_of(0, 0)})
        EXPECT_EQ(step_after({before, last}), expected);
    const ClothSettings stiff_bending = settings_of(50, 1e-2f);
    EXPECT_EQ(step_after({last, stiff_bending}), step_after({stiff_bending}));
}

TEST(MultilevelSolver, TakesTheSmallestCloth) {
    ClothSettings settings = stiff();
    settings.method = Multilevel{};
    World world = World::create(still_world()).value();
    const ClothId id = world.add_cloth(sheet(2, 2), settings).value();
    ASSERT_TRUE(world.pin(id, 0).ok());
    for (int k = 0; k < 60; ++k) world.step(h);
    EXPECT_EQ(world.report().flags, StepFlags::none);
    EXPECT_LT(world.cloth(id)->bounds.lower.y, -0.5f);
}

}  // namespace
}  // namespace weft::test
