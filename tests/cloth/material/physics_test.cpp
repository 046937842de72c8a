// The World against closed forms and conservation laws.

#include <gtest/gtest.h>

#include <cmath>

#include "engine/vector.h"
#include "tests/cloth/fixtures.h"

namespace weft::test {
namespace {

ClothSettings undamped(float stretch, int iterations) {
    ClothSettings settings;
    settings.fabric = {
        .warp = stretch, .weft = stretch, .shear = 0.25f * stretch, .bending = 5e-8f * stretch, .damping = 0};
    settings.method = Jacobi{.iterations = iterations};
    settings.air_damping = 0;
    return settings;
}

/// Mass, momenta and centre of a cloth, in double precision.
struct Motion {
    double mass = 0;
    Eigen::Vector3d center = Eigen::Vector3d::Zero(), momentum = Eigen::Vector3d::Zero(),
                    angular_momentum = Eigen::Vector3d::Zero();
};

Motion motion(const ClothView& cloth) {
    Motion sum;
    for (std::size_t i = 0; i < cloth.positions.size(); ++i) {
        const double m = 1.0 / static_cast<double>(cloth.positions[i].w);
        const Eigen::Vector3d x = xyz(cloth.positions[i]).cast<double>(),
                              v = xyz(cloth.velocities[i]).cast<double>();
        sum.mass += m;
        sum.center += m * x;
        sum.momentum += m * v;
        sum.angular_momentum += m * x.cross(v);
    }
    sum.center /= sum.mass;
    return sum;
}

class FreeFall : public testing::TestWithParam<int> {};

TEST_P(FreeFall, IsExactToRoundingForAnyNumberOfIterations) {
    World world = World::create(vacuum({0, -9.81f, 0})).value();
    const ClothId id = world.add_cloth(sheet(24, 24), undamped(400, GetParam())).value();
    const ClothView start = world.cloth(id).value();
    const std::vector<Vec4> first(start.positions.begin(), start.positions.end());
    constexpr int steps = 60;
    for (int k = 0; k < steps; ++k) world.step(h);

    // Backward Euler falls by g h^2 n (n + 1) / 2, ahead of g t^2 / 2 by g h t / 2.
    const float drop = 9.81f * h * h * steps * (steps + 1) / 2;
    const ClothView cloth = world.cloth(id).value();
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_NEAR(cloth.velocities[i].y, -9.81f * h * steps, 1e-5f * 9.81f);
        EXPECT_NEAR(cloth.positions[i].y, first[i].y - drop, 2e-5f * drop);
        EXPECT_NEAR(cloth.positions[i].x, first[i].x, 1e-6f);
        EXPECT_NEAR(cloth.positions[i].z, first[i].z, 1e-6f);
    }
}

INSTANTIATE_TEST_SUITE_P(Iterations, FreeFall, testing::Values(0, 1, 2, 9),
                         testing::PrintToStringParamName());

TEST(FreeFall, IsExactForAVerticalSheetAndManyComponents) {
    Mesh mesh = sheet(8, 8);
    for (Vec3& x : mesh.positions) std::swap(x.y, x.z);
    World world = World::create(vacuum({0, -9.81f, 0})).value();
    const ClothId id = world.add_cloth(mesh, undamped(4000, 1)).value();
    for (int k = 0; k < 30; ++k) world.step(h);
    const ClothView cloth = world.cloth(id).value();
    for (const Vec4& v : cloth.velocities) EXPECT_NEAR(v.y, -9.81f * 0.5f, 1e-4f);
}

TEST(AirDamping, DecaysVelocityByBackwardEuler) {
    World world = World::create(vacuum({0, -9.81f, 0})).value();
    ClothSettings settings = undamped(0, 1);
    settings.air_damping = 0.5f;
    const ClothId id = world.add_cloth(sheet(2, 2), settings).value();
    double v = 0;
    for (int k = 0; k < 120; ++k) {
        world.step(h);
        v = (v - 9.81 * static_cast<double>(h)) / (1 + 0.5 * static_cast<double>(h));
    }
    EXPECT_NEAR(world.cloth(id)->velocities[0].y, v, 1e-4);
}

/// A sheet that is stretched by a tenth along x, so that it oscillates and, seen from aside, spins.
Mesh stretched_sheet() {
    Mesh mesh = sheet(10, 10);
    mesh.pattern = mesh.texcoords;
    for (Vec3& x : mesh.positions) x = {1.1f * x.x, 0.05f * std::sin(7 * x.x + 3 * x.z), x.z + 0.2f * x.x};
    return mesh;
}

TEST(Momentum, LinearIsKeptAtAnyNumberOfIterations) {
    for (const int iterations : {1, 3, 50}) {
        World world = World::create(vacuum()).value();
        const ClothId id = world.add_cloth(stretched_sheet(), undamped(400, iterations)).value();
        float peak = 0;
        for (int k = 0; k < 60; ++k) {
            world.step(h);
            peak = std::max(peak, world.report().peak_speed);
        }
        const Motion end = motion(world.cloth(id).value());
        EXPECT_GT(peak, 0.01f) << "it must move for the test to say anything";
        EXPECT_LT(end.momentum.norm(), 5e-5 * end.mass * static_cast<double>(peak))
            << iterations << " iterations";
    }
}

/// |L| after half a second of a sheet that starts at rest but stretched askew, converged iterations.
double angular_drift(int substeps) {
    WorldSettings settings = vacuum();
    settings.substeps = substeps;
    World world = World::create(settings).value();
    ClothSettings cloth_settings = undamped(40, 600);
    const ClothId id = world.add_cloth(stretched_sheet(), cloth_settings).value();
    for (int k = 0; k < 15; ++k) world.step(h);
    const Motion end = motion(world.cloth(id).value());
    return (end.angular_momentum - end.mass * end.center.cross(end.momentum / end.mass)).norm();
}

TEST(Momentum, AngularIsKeptToFirstOrderInTheStep) {
    // Backward Euler applies each force at the end of the step but evaluates its lever at the start: the
    // error falls with h.
    const double coarse = angular_drift(1), fine = angular_drift(4);
    EXPECT_LT(fine, 0.45 * coarse + 1e-7);
    EXPECT_LT(fine, 1e-3)
        << "kg m^2/s; the sheet's inertia about its centre is 0.03 kg m^2, its springs pull at 1/s and more";
}

TEST(Pins, MoveToTheirTargetsInOneStepWhateverTheSubsteps) {
    for (const int substeps : {1, 3, 7}) {
        WorldSettings settings;
        settings.substeps = substeps;
        World world = World::create(settings).value();
        const ClothId id = world.add_cloth(sheet(6, 6)).value();
        ASSERT_TRUE(world.pin(id, 0).ok());
        ASSERT_TRUE(world.move_pin(id, 0, {-0.4f, 0.1f, -0.45f}).ok());
        world.step(h);
        const Vec4 there = world.cloth(id)->positions[0];
        EXPECT_EQ(Vector3(there.x, there.y, there.z), Vector3(-0.4f, 0.1f, -0.45f));
        EXPECT_NEAR(world.cloth(id)->velocities[0].x, 0.1f / h, 1e-3f);
        world.step(h);
        EXPECT_EQ(world.cloth(id)->velocities[0].x, 0) << "a pin that is not moved on stands still";
    }
}

TEST(Pins, ReleasedParticlesGetTheirMassBack) {
    World world = World::create(vacuum({0, -9.81f, 0})).value();
    const ClothId id = world.add_cloth(sheet(6, 6), undamped(400, 1)).value();
    const float free = world.cloth(id)->positions[0].w;
    ASSERT_TRUE(world.pin(id, 0).ok());
    EXPECT_EQ(world.cloth(id)->positions[0].w, 0);
    ASSERT_TRUE(world.unpin(id, 0).ok());
    EXPECT_EQ(world.cloth(id)->positions[0].w, free);
    world.step(h);
    EXPECT_NEAR(world.cloth(id)->velocities[0].y, -9.81f * h, 1e-6f);
}

TEST(Collapse, AllParticlesAtOnePointOpenUpAgain) {
    Mesh mesh = sheet(8, 8);
    mesh.pattern = mesh.texcoords;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        mesh.positions[v] = {1e-6f * static_cast<float>(v), 0, 0};  // at one point, but not welded
    }
    World world = World::create(vacuum()).value();
    ClothSettings settings = undamped(40, 31);
    settings.fabric.damping = 0.01f;
    const ClothId id = world.add_cloth(mesh, settings).value();
    for (int k = 0; k < 300; ++k) world.step(h);
    EXPECT_EQ(world.report().flags, StepFlags::none);
    const Bounds bounds = world.cloth(id)->bounds;
    EXPECT_GT((to_vector(bounds.upper) - to_vector(bounds.lower)).norm(), 0.5f);
}

/// The largest stretch of a sheet's rows and columns: length over length at rest.
double longest_thread(const ClothView& cloth, std::uint32_t side) {
    const auto at = [&](std::uint32_t row, std::uint32_t column) {
        return xyz(cloth.positions[cloth.vertex_to_particle[row * side + column]]);
    };
    float longest = 0;
    for (std::uint32_t k = 0; k < side; ++k)
        for (std::uint32_t m = 0; m + 1 < side; ++m)
            longest = std::max({longest, (at(k, m + 1) - at(k, m)).norm(), (at(m + 1, k) - at(m, k)).norm()});
    return static_cast<double>(longest) * (side - 1);
}

TEST(Wind, StormsDoNotBreakTheCloth) {
    constexpr std::uint32_t side = 20;
    for (const float speed : {20.0f, 60.0f, 200.0f}) {
        SCOPED_TRACE(speed);
        WorldSettings settings;
        settings.wind.velocity = {speed, 0, 0};
        settings.wind.gust = 0.5f;
        World world = World::create(settings).value();
        const ClothId id = world.add_cloth(sheet(side, side)).value();
        for (std::uint32_t r = 0; r < side; ++r) ASSERT_TRUE(world.pin(id, side * r).ok());
        for (int k = 0; k < 120; ++k) {
            const StepReport& report = world.step(h);
            EXPECT_LE(report.peak_speed, 1.0001f * settings.max_speed) << "step " << k;
            EXPECT_FALSE(has(report.flags, StepFlags::state_restored)) << "step " << k;
            EXPECT_EQ(has(report.flags, StepFlags::speed_limited),
                      report.peak_speed > 0.999f * settings.max_speed)
                << "step " << k;
        }
        settings.wind.velocity = {};
        ASSERT_TRUE(world.set_settings(settings));
        for (int k = 0; k < 600; ++k) world.step(h);
        EXPECT_LT(world.report().peak_speed, 0.5f) << "after the storm it hangs";
        EXPECT_LT(longest_thread(world.cloth(id).value(), side), 1.1);
    }
}

TEST(Wind, FallingSheetReachesTerminalVelocity) {
    // Flat and stiff to bending it would flutter; a soft damped one that is held flat by symmetry falls at
    // the speed at which drag carries its weight: sigma g = 1/2 rho v^2 Cd.
    WorldSettings settings;
    settings.wind.drag = 1.0f;
    World world = World::create(settings).value();
    ClothSettings cloth_settings;
    cloth_settings.air_damping = 0;
    const ClothId id = world.add_cloth(sheet(6, 6), cloth_settings).value();
    for (int k = 0; k < 240; ++k) world.step(h);
    const double terminal = std::sqrt(2 * 0.2 * 9.81 / (1.2 * 1.0));
    EXPECT_NEAR(-motion(world.cloth(id).value()).momentum.y() / 0.2, terminal, 0.05 * terminal);
}

}  // namespace
}  // namespace weft::test
