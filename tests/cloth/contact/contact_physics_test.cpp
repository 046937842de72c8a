// Cloth on colliders against closed forms, at one step a frame.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/vector.h"
#include "tests/cloth/colliders/sloping_sheet.h"
#include "tests/cloth/fixtures.h"

namespace weft::test {
namespace {

constexpr double standard_gravity = 9.80665;
constexpr Vec3 fall{0, -static_cast<float>(standard_gravity), 0};

/// Least length b of rope beyond a rough cylinder of radius r that pulls the length a on this side over it:
/// Euler and Eytelwein's belt, with its own weight.
double slipping_length(double a, double friction, double r) {
    constexpr int parts = 20000;
    const double d_phi = std::numbers::pi / parts;
    double tension = a;  // per weight of a unit of length
    for (int k = 0; k < parts; ++k) {
        const double phi = -std::numbers::pi / 2 + (k + 0.5) * d_phi;
        tension += d_phi * (friction * (tension + r * std::cos(phi)) - r * std::sin(phi));
    }
    return tension;
}

/// A strip over a cylinder, one side longer: how far that side sinks within a second, the friction being
/// `part` of what just holds it.
double strip_sinks(double part, const ClothSettings& given) {
    constexpr float length = 1.2f, width = 0.06f, radius = 0.1f, thickness = 0.005f;
    constexpr std::uint32_t rows = 97, columns = 6;
    World world = World::create(vacuum(fall)).value();
    ClothSettings settings = given;
    settings.thickness = thickness;
    settings.friction = 1;
    const Mesh strip = make_sheet({.rows = rows,
                                   .columns = columns,
                                   .origin = {-0.46f, radius + thickness + 1e-3f, -0.5f * width},
                                   .u = {0, 0, width},
                                   .v = {length, 0, 0}})
                           .value();
    const ClothId id = world.add_cloth(strip, settings).value();
    const Capsule cylinder{{0, 0, -1}, {0, 0, 1}, radius};
    const ColliderId collider = world.add_collider({.shape = cylinder, .friction = 1}).value();
    const auto hangs = [&](std::uint32_t row) {
        const ClothView view = world.cloth(id).value();
        return -static_cast<double>(view.positions[view.vertex_to_particle[row * columns + columns / 2]].y);
    };
    for (int step = 0; step < 480; ++step) world.step(h);
    const double a = hangs(0), b = hangs(rows - 1);
    EXPECT_GT(a, 0.25);
    EXPECT_LT(a, b);
    double low = 0, high = 1;
    for (int k = 0; k < 40; ++k) {
        const double middle = 0.5 * (low + high), r = static_cast<double>(radius + thickness);
        (slipping_length(a, middle, r) < b ? low : high) = middle;
    }
    EXPECT_TRUE(
        world.move_collider(collider, {.shape = cylinder, .friction = static_cast<float>(part * low)}));
    for (int step = 0; step < 60; ++step) world.step(h);
    return hangs(rows - 1) - b;
}

TEST(ContactPhysics, ARopeOverACylinderHoldsAndSlipsByEulersLaw) {
    ClothSettings settings;
    settings.sleep_speed = 0;  // beyond the angle it slips slowly at first
    settings.air_damping = 2;  // at rest before the friction falls: ends that swing pull more than they weigh
    EXPECT_NEAR(strip_sinks(1.02, settings), 0, 0.001);
    EXPECT_GT(strip_sinks(0.98, settings), 0.004);
    EXPECT_GT(strip_sinks(0.8, settings), 0.1);
}

/// How far a sheet slides down a slope in a second [m].
double slides(double angle, double friction, int substeps) {
    SlopingSheet sheet(angle, substeps);
    EXPECT_TRUE(sheet.world.add_collider(
        {.shape = Plane{to_vec3(sheet.normal), 0}, .friction = static_cast<float>(friction)}));
    const double start = sheet.place();
    sheet.run(60);
    return sheet.place() - start;
}

TEST(ContactPhysics, ASheetOnASlopeRestsBelowTheFrictionAngle) {
    const double angle = 0.5, least = std::tan(angle);
    EXPECT_NEAR(slides(angle, 1.05 * least, 1), 0, 5e-4);
    EXPECT_NEAR(slides(angle, 2 * least, 1), 0, 2e-4);
}

TEST(ContactPhysics, ASheetOnASlopeSlidesByCoulombsLawAboveIt) {
    const double angle = 0.5;
    const auto expected = [&](double friction) {
        return 0.5 * standard_gravity * (std::sin(angle) - friction * std::cos(angle));
    };
    EXPECT_NEAR(slides(angle, 0, 1), expected(0), 0.03 * expected(0));
    EXPECT_NEAR(slides(angle, 0.2, 1), expected(0.2), 0.08 * expected(0.2));
    EXPECT_NEAR(slides(angle, 0.4, 1), expected(0.4), 0.1 * expected(0.4));
    EXPECT_NEAR(slides(angle, 0.4, 4), expected(0.4), 0.08 * expected(0.4));
}

/// How long threads are over how long they rest: the longest in any frame while a 1 m sheet falls onto a
/// ball, and their mean at the end. One step a frame.
struct Threads {
    double longest = 0, mean = 0;
};
Threads threads_on_ball(const ClothSettings& settings) {
    constexpr std::uint32_t side = 64;
    World world = World::create(vacuum(fall)).value();
    const Mesh mesh =
        make_sheet(
            {.rows = side, .columns = side, .origin = {-0.5f, 0.7f, -0.5f}, .u = {1, 0, 0}, .v = {0, 0, 1}})
            .value();
    const ClothId id = world.add_cloth(mesh, settings).value();
    EXPECT_TRUE(world.add_collider({.shape = Sphere{{0, 0.3f, 0}, 0.3f}, .friction = 0.5f}));
    EXPECT_TRUE(world.add_collider({.shape = Plane{}, .friction = 0.6f}));
    Threads threads;
    for (int step = 0; step < 50; ++step) {
        EXPECT_FALSE(has(world.step(h).flags, StepFlags::state_restored));
        const ClothView view = world.cloth(id).value();
        const auto at = [&](std::uint32_t row, std::uint32_t column) {
            return xyz(view.positions[view.vertex_to_particle[row * side + column]]);
        };
        threads.mean = 0;
        for (std::uint32_t k = 0; k < side; ++k) {
            for (std::uint32_t m = 0; m + 1 < side; ++m) {
                for (const Vector3& thread :
                     {Vector3(at(k, m + 1) - at(k, m)), Vector3(at(m + 1, k) - at(m, k))}) {
                    const double length = static_cast<double>(thread.norm()) * (side - 1);
                    threads.longest = std::max(threads.longest, length);
                    threads.mean += length / (2.0 * side * (side - 1));
                }
            }
        }
    }
    return threads;
}

// Met after the step alone, contacts let the ball through the weave: threads grow to twice their length and
// more. As it is the longest of 8000 is 1.2 to 1.6 times as long, which rounding decides: thickness changed
// by a millionth gives any of these.
TEST(ContactPhysics, AFineSheetOnABallStaysWholeAtOneStepAFrame) {
    std::vector<ClothSettings> cases(6);
    cases[1].self_collision.method = SelfCollisionMethod::contact;
    cases[2].time_scheme = TimeScheme::bdf2;
    cases[3].finite_elements.enabled = true;
    cases[4].method = Multilevel{.passes = 1};
    cases[5].method = ConjugateGradient{.iterations = 48};
    for (std::size_t k = 0; k < cases.size(); ++k) {
        SCOPED_TRACE(k);
        cases[k].thickness = 0.008f;
        const Threads threads = threads_on_ball(cases[k]);
        EXPECT_LT(threads.longest, 1.75);
        EXPECT_NEAR(threads.mean, 1, 0.005);
    }
}

TEST(ContactPhysics, LetGo) {
    World world = World::create(vacuum(fall)).value();
    ClothSettings settings;
    settings.air_damping = 0;
    const Mesh mesh = make_sheet({.rows = 12,
                                  .columns = 12,
                                  .origin = {0, settings.thickness, 0},
                                  .u = {0.3f, 0, 0},
                                  .v = {0, 0, 0.3f}})
                          .value();
    const ClothId id = world.add_cloth(mesh, settings).value();
    EXPECT_TRUE(world.add_collider({.shape = Plane{}, .friction = 1}));
    for (int step = 0; step < 20; ++step) world.step(h);
    WorldSettings upwards = world.settings();
    upwards.gravity = {0, static_cast<float>(standard_gravity), 0};
    EXPECT_TRUE(world.set_settings(upwards));
    constexpr int steps = 10;
    for (int step = 0; step < steps; ++step) world.step(h);
    const ClothView view = world.cloth(id).value();
    for (const Vec4& v : view.velocities) {
        EXPECT_LE(static_cast<double>(v.y), standard_gravity * steps / 60 + 5e-4);
        EXPECT_GT(static_cast<double>(v.y),
                  standard_gravity * (steps - 1.5) / 60);  // held for no more than a step
    }
}

}  // namespace
}  // namespace weft::test
