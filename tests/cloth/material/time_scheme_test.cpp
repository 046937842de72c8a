// How methods step through time: orders of accuracy, starts, stops and restarts of BDF2, explicit stability.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"
#include "tests/cloth/system/dense_algebra.h"

namespace weft::test {
namespace {

ClothSettings undamped(float stretch, const Method& method, TimeScheme scheme, int substeps = 1) {
    ClothSettings settings;
    settings.fabric = {
        .warp = stretch, .weft = stretch, .shear = 0.25f * stretch, .bending = 5e-8f * stretch, .damping = 0};
    settings.air_damping = 0;
    settings.method = method;
    settings.time_scheme = scheme;
    settings.substeps = substeps;
    return settings;
}

const Method converged = ConjugateGradient{.iterations = 300};

/// A sheet of `n` by `n`, stretched by a fifth and pinned all around.
struct Membrane {
    Membrane(std::uint32_t n, const ClothSettings& settings)
        : world(World::create(vacuum(downwards)).value()) {
        Mesh mesh = sheet(n, n);
        mesh.pattern = mesh.texcoords;
        for (Vec3& x : mesh.positions) x = {1.2f * x.x, 0, 1.2f * x.z};
        id = world.add_cloth(mesh, settings).value();
        for (std::uint32_t i = 0; i < n * n; ++i) {
            const bool border = i / n == 0 || i / n == n - 1 || i % n == 0 || i % n == n - 1;
            if (border) (void)world.pin(id, i);
            if (i / n == n - 1) rim.push_back(i);
        }
    }
    /// Each frame the last row of pins moves by `pull`.
    void run(int frames, const Vec3& pull) {
        for (int k = 0; k < frames; ++k) {
            for (const std::uint32_t i : rim) {
                const Vec4 x = world.cloth(id)->positions[i];
                (void)world.move_pin(id, i, {x.x + pull.x, x.y + pull.y, x.z + pull.z});
            }
            world.step(h);
        }
    }
    [[nodiscard]] Eigen::VectorXd positions() const { return flat(world.cloth(id)->positions); }

    World world;
    ClothId id;
    std::vector<std::uint32_t> rim;
};

/// Where a membrane that falls under gravity is after a fifth of a second. Every spring stays in tension,
/// where the linearisation is exact.
Eigen::VectorXd fallen(const Method& method, TimeScheme scheme, int substeps, const Vec3& pull) {
    Membrane membrane(7, undamped(8, method, scheme, substeps));
    membrane.run(12, pull);
    return membrane.positions();
}

struct Order {
    double order;
    Eigen::VectorXd finest;
};

/// From the differences of three runs, each with half the step of the one before.
Order order_of(TimeScheme scheme, const Vec3& pull) {
    const Eigen::VectorXd coarse = fallen(converged, scheme, 4, pull),
                          middle = fallen(converged, scheme, 8, pull),
                          fine = fallen(converged, scheme, 16, pull);
    return {std::log2((coarse - middle).norm() / (middle - fine).norm()), fine};
}

class InTension : public testing::TestWithParam<Vec3> {};
INSTANTIATE_TEST_SUITE_P(Pins, InTension, testing::Values(Vec3{0, 0, 0}, Vec3{0, 0.004f, 0.003f}),
                         [](const auto& info) { return info.index == 0 ? "Still" : "Moving"; });

TEST_P(InTension, BackwardEulerIsOfFirstOrderAndBdf2OfSecond) {
    const Order first = order_of(TimeScheme::backward_euler, GetParam());
    const Order second = order_of(TimeScheme::bdf2, GetParam());
    EXPECT_NEAR(first.order, 1, 0.25);
    EXPECT_NEAR(second.order, 2, 0.3);
    // Both go to where the explicit method goes.
    const Eigen::VectorXd reference = fallen(SymplecticEuler{}, TimeScheme::backward_euler, 300, GetParam());
    EXPECT_LT((second.finest - reference).norm(), 0.1 * (first.finest - reference).norm());
    EXPECT_LT((first.finest - reference).norm(), 0.05 * (reference - Membrane(7, {}).positions()).norm());
}

TEST(Bdf2, FallsAheadOfTheTruthByNoMoreThanItsFirstStep) {
    // Backward Euler starts it, with an error of g h^2 / 2 that neither grows nor fades.
    World world = World::create(vacuum(downwards)).value();
    const ClothId id = world.add_cloth(sheet(5, 5), undamped(400, converged, TimeScheme::bdf2)).value();
    for (int k = 1; k <= 60; ++k) {
        world.step(h);
        const float t = static_cast<float>(k) * h;
        EXPECT_NEAR(world.cloth(id)->velocities[7].y, -9.81f * t, 1e-4f) << k;
        EXPECT_NEAR(world.cloth(id)->positions[7].y, -0.5f * 9.81f * t * t, 9.81f * h * h) << k;
    }
}

TEST(Bdf2, ReleasedClothFallsAtOnceWithItsFullWeight) {
    World world = World::create(vacuum(downwards)).value();
    const ClothId id = world.add_cloth(sheet(5, 5), undamped(400, converged, TimeScheme::bdf2)).value();
    for (std::uint32_t i = 0; i < 25; ++i) ASSERT_TRUE(world.pin(id, i).ok());
    for (int k = 0; k < 5; ++k) world.step(h);
    for (std::uint32_t i = 0; i < 25; ++i) ASSERT_TRUE(world.unpin(id, i).ok());
    for (int k = 1; k <= 20; ++k) {
        world.step(h);
        EXPECT_NEAR(world.cloth(id)->velocities[7].y, -9.81f * h * static_cast<float>(k), 1e-4f) << k;
    }
}

TEST(Bdf2, PinsReachTheirTargetsWhateverTheSubsteps) {
    for (const int substeps : {1, 3, 8}) {
        Membrane membrane(5, undamped(100, converged, TimeScheme::bdf2, substeps));
        Vec3 target{0.61f, 0.013f, 0.59f};
        for (int k = 0; k < 4; ++k) {
            target.x += 0.01f;
            ASSERT_TRUE(membrane.world.move_pin(membrane.id, 24, target).ok());
            membrane.world.step(h);
            const Vec4 there = membrane.world.cloth(membrane.id)->positions[24];
            EXPECT_EQ(Vector3(there.x, there.y, there.z), to_vector(target));
        }
    }
}

TEST(Bdf2, TakesItsSecondOrderUpAgainAfterAChangeOfStep) {
    // Steps of 4 ms, then of 2 ms: as if run with steps between the two throughout.
    const auto run = [](TimeScheme scheme, int divisor) {
        Membrane membrane(7, undamped(8, converged, scheme));
        for (int k = 0; k < 25 * divisor; ++k) membrane.world.step(0.004f / static_cast<float>(divisor));
        for (int k = 0; k < 50 * divisor; ++k) membrane.world.step(0.002f / static_cast<float>(divisor));
        return membrane.positions();
    };
    const Eigen::VectorXd exact = run(TimeScheme::bdf2, 8);
    const double second = (run(TimeScheme::bdf2, 1) - exact).norm();
    EXPECT_LT(second, 0.2 * (run(TimeScheme::backward_euler, 1) - exact).norm());
    EXPECT_LT((run(TimeScheme::bdf2, 2) - exact).norm(), 0.35 * second);
}

/// A flat sheet above the plane y = 0, which it keeps 5 mm away from.
struct Landing {
    Landing(TimeScheme scheme, float height, float friction)
        : world(World::create(vacuum(downwards)).value()) {
        Mesh mesh = sheet(6, 6);
        for (Vec3& x : mesh.positions) x.y = height;
        ClothSettings settings = undamped(100, converged, scheme);
        id = world.add_cloth(mesh, settings).value();
        (void)world.add_collider({.shape = Plane{.normal = {0, 1, 0}, .offset = 0}, .friction = friction})
            .value();
    }
    World world;
    ClothId id;
};

TEST(Bdf2, ComesToRestOnTheGroundWithoutABounce) {
    Landing landing(TimeScheme::bdf2, 0.3f, 1);
    float lowest = 1;
    for (int k = 0; k < 120; ++k) {
        landing.world.step(h);
        const float y = landing.world.cloth(landing.id)->positions[14].y;
        EXPECT_LT(y, lowest + 1e-4f) << "never up again, step " << k;
        lowest = std::min(lowest, y);
    }
    const ClothView cloth = landing.world.cloth(landing.id).value();
    for (const Vec4& x : cloth.positions) EXPECT_NEAR(x.y, 0.005f, 1e-4f);
    EXPECT_LT(landing.world.report().peak_speed, 1e-3f);
}

TEST(Bdf2, ClothThatMeetsTheGroundForgetsHowItFell) {
    // What was a fall of 2 m/s may not carry any particle below the ground, nor stretch the cloth, one step
    // after it has been stopped.
    for (const TimeScheme scheme : {TimeScheme::backward_euler, TimeScheme::bdf2}) {
        Landing landing(scheme, 0.25f, 0);
        for (int k = 0; k < 40; ++k) {
            landing.world.step(h);
            const ClothView cloth = landing.world.cloth(landing.id).value();
            for (const Vec4& x : cloth.positions) ASSERT_GE(x.y, 0.005f - 1e-5f) << k;
            EXPECT_NEAR(cloth.positions[35].x - cloth.positions[0].x, 1, 1e-4f) << k;
        }
    }
}

TEST(Bdf2, DampsNoiseOfStiffCloth) {
    World world = World::create(vacuum({0, 0, 0})).value();
    Mesh mesh = sheet(8, 8);
    mesh.pattern = mesh.texcoords;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> offset(-1e-4f, 1e-4f);
    for (Vec3& x : mesh.positions) x = {x.x + offset(random), 0, x.z + offset(random)};
    (void)world.add_cloth(mesh, undamped(4e4f, converged, TimeScheme::bdf2)).value();
    world.step(h);
    const float first = world.report().peak_speed;
    for (int k = 0; k < 60; ++k) world.step(h);
    EXPECT_LT(world.report().peak_speed, 0.1f * first);
}

/// The highest angular frequency of a cloth at rest: omega^2 M = -J.
double highest_frequency(Cloth& cloth) {
    for (Vec4& v : cloth.state.velocities.span()) v = {};
    constexpr double h = 1;
    const Eigen::MatrixXd w = dense(*assembled(cloth, static_cast<float>(h))).matrix;
    Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(w.rows(), w.cols());
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        mass.diagonal()
            .segment<3>(3 * static_cast<Eigen::Index>(i))
            .setConstant(static_cast<double>(cloth.mass(i)));
    }
    return std::sqrt(largest_generalised_eigenvalue(w - mass, mass)) / h;
}

/// Peak speed after `steps` steps of `h`, from noise of a hundredth of a millimetre.
float speed_after(int steps, double h) {
    World world = World::create(vacuum({0, 0, 0})).value();
    Mesh mesh = sheet(5, 5);
    mesh.pattern = mesh.texcoords;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> offset(-1e-5f, 1e-5f);
    for (Vec3& x : mesh.positions) x = {x.x + offset(random), offset(random), x.z + offset(random)};
    (void)world.add_cloth(mesh, undamped(100, SymplecticEuler{}, TimeScheme::backward_euler)).value();
    for (int k = 0; k < steps; ++k) world.step(static_cast<float>(h));
    return world.report().peak_speed;
}

TEST(SymplecticEuler, IsStableJustInsideItsBoundAndFailsJustOutside) {
    Cloth cloth(cook(sheet(5, 5)).value(), undamped(100, SymplecticEuler{}, TimeScheme::backward_euler));
    const double bound = 2 / highest_frequency(cloth);
    EXPECT_LT(speed_after(2000, 0.98 * bound), 0.1f);
    EXPECT_GT(speed_after(2000, 1.02 * bound), 1.0f);
}

TEST(SymplecticEuler, FallsAsItMust) {
    World world = World::create(vacuum(downwards)).value();
    ClothSettings settings = undamped(0, SymplecticEuler{}, TimeScheme::backward_euler);
    settings.air_damping = 0.5f;
    const ClothId id = world.add_cloth(sheet(3, 3), settings).value();
    double v = 0, y = 0;
    constexpr double dt = static_cast<double>(h);
    for (int k = 0; k < 60; ++k) {
        world.step(h);
        v = (v - 9.81 * dt) / (1 + 0.5 * dt);
        y += dt * v;
    }
    EXPECT_NEAR(static_cast<double>(world.cloth(id)->velocities[4].y), v, 1e-4);
    EXPECT_NEAR(static_cast<double>(world.cloth(id)->positions[4].y), y, 1e-4);
}

TEST(SymplecticEuler, TakesSpringsForcesWhereParticlesAre) {
    // One step from a crumpled state equals h times the force over the mass, damping and drag included.
    Cloth cloth = crumpled(sheet(5, 5), 0.03f, 60.0f);
    ClothSettings settings = cloth.settings;
    settings.fabric.damping = 1e-3f;
    settings.method = SymplecticEuler{};
    cloth.apply(settings);
    constexpr float h = 1e-3f;
    Parallel serial(1);
    Profiler profiler(stage_names);
    cloth.solver->lay_out_alone();
    cloth.solver->solve({.parallel = serial,
                         .profiler = profiler,
                         .model = cloth.model,
                         .settings = cloth.settings,
                         .equation = equation_of(cloth, h),
                         .velocities = cloth.scratch_velocities.span()});
    const Eigen::VectorXd change = velocity_change(cloth);
    const ClothModel& model = cloth.model;
    std::vector<float> stiffness(model.neighbours.size());
    spring_stiffness(model, cloth.settings.fabric, stiffness);
    const auto rigidity = static_cast<double>(cloth.settings.fabric.bending);
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        Eigen::Vector3d force(0, -9.81 * static_cast<double>(cloth.mass(i)), 0);
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
            const std::uint32_t j = model.neighbours[e];
            const auto k = static_cast<double>(stiffness[e]);
            const Eigen::Vector3d d =
                (xyz(cloth.state.positions[j]) - xyz(cloth.state.positions[i])).cast<double>();
            const Eigen::Vector3d u =
                (xyz(cloth.state.velocities[j]) - xyz(cloth.state.velocities[i])).cast<double>();
            const Eigen::Vector3d n = d.normalized();
            force += rigidity * static_cast<double>(model.bending[e]) * (d + 1e-3 * u);
            force +=
                k * (d.norm() - static_cast<double>(model.rest_lengths[e])) * n + 1e-3 * k * n.dot(u) * n;
        }
        const Eigen::Vector3d expected = static_cast<double>(h) / static_cast<double>(cloth.mass(i)) * force;
        EXPECT_LT((change.segment<3>(3 * static_cast<Eigen::Index>(i)) - expected).norm(),
                  1e-4 * expected.norm() + 1e-6);
    }
}

}  // namespace
}  // namespace weft::test
