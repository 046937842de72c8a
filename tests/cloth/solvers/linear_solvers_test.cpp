// What every solver of the linear system must do, whatever its iteration.

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"
#include "tests/cloth/system/dense_algebra.h"

namespace weft::test {
namespace {

struct NamedMethod {
    const char* name;
    Method few, many;  ///< too few iterations to converge, and enough
};

void PrintTo(const NamedMethod& method, std::ostream* out) {
    *out << method.name;
}

class LinearSolvers : public testing::TestWithParam<NamedMethod> {};

INSTANTIATE_TEST_SUITE_P(
    Methods, LinearSolvers,
    testing::Values(NamedMethod{"Jacobi", Jacobi{.iterations = 3}, Jacobi{.iterations = 6000}},
                    NamedMethod{"Chebyshev", Chebyshev{.iterations = 3}, Chebyshev{.iterations = 800}},
                    NamedMethod{"ConjugateGradient", ConjugateGradient{.iterations = 3},
                                ConjugateGradient{.iterations = 600}}),
    [](const auto& info) { return std::string(info.param.name); });

/// A general mesh whose triangles differ in size and shape.
Mesh irregular() {
    Mesh mesh = loose_sheet(7, 6);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> offset(-0.05f, 0.05f);
    for (Vec3& x : mesh.positions) x = {x.x + offset(random), x.y, x.z + offset(random)};
    mesh.pattern.clear();
    mesh.texcoords.clear();
    return mesh;
}

/// One step's velocity change by the cloth's own method.
struct Solved {
    Eigen::VectorXd change;
    float residual;
};

Solved solve(Cloth& cloth, const Method& method, int threads = 1) {
    ClothSettings settings = cloth.settings;
    settings.method = method;
    cloth.apply(settings);
    Parallel parallel(threads);
    Profiler profiler(stage_names);
    cloth.solver->lay_out_alone();
    const SolveResult result = cloth.solver->solve({.parallel = parallel,
                                                    .profiler = profiler,
                                                    .model = cloth.model,
                                                    .settings = cloth.settings,
                                                    .equation = equation_of(cloth, 1.0f / 60),
                                                    .velocities = cloth.scratch_velocities.span()});
    return {velocity_change(cloth), result.residual};
}

bool has_slack_springs(const Cloth& cloth) {
    const ClothModel& model = cloth.model;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
            const Vector3 d = xyz(cloth.state.positions[model.neighbours[e]]) - xyz(cloth.state.positions[i]);
            if (d.norm() < 0.9f * model.rest_lengths[e]) return true;
        }
    }
    return false;
}

TEST_P(LinearSolvers, ConvergeToTheDenseSolution) {
    const std::vector<NamedMesh> meshes{
        {"sheet", sheet(6, 7)},
        {"irregular", irregular()},
        {"fan", fan(20)},
        {"two components", joined(irregular(), sphere(1), {0, 3, 0})},
    };
    for (const NamedMesh& mesh : meshes) {
        for (const std::uint32_t pins : {0u, 3u}) {
            Cloth cloth = crumpled(mesh.mesh, 0.04f, 60.0f);
            for (std::uint32_t p = 0; p < pins; ++p) cloth.pin(4 * p + 1);
            ASSERT_TRUE(has_slack_springs(cloth)) << mesh.name;
            const DenseSystem system = dense(*assembled(cloth, 1.0f / 60));
            const Eigen::VectorXd exact = solution(system.matrix, system.right_side);
            const Solved found = solve(cloth, GetParam().many);
            EXPECT_LT((found.change - exact).norm(), 3e-5 * exact.norm())
                << mesh.name << ", " << pins << " pins";
            // In a mesh what triangles' sides do to one another is not in the matrix: passes come to it.
            EXPECT_LT(found.residual, mesh.mesh.rows > 0 ? 0.1f : 0.6f)
                << "one linearisation leaves that much, " << mesh.name << ", " << pins << " pins";
        }
    }
}

TEST_P(LinearSolvers, LeavePinnedParticlesAlone) {
    Cloth cloth = crumpled(irregular(), 0.04f, 1e5f);
    for (const std::uint32_t p : {0u, 5u, 17u}) cloth.pin(p);
    solve(cloth, GetParam().few);
    for (const Pin& pin : cloth.state.pins) {
        EXPECT_EQ(xyz(cloth.scratch_velocities[pin.particle]), xyz(cloth.state.velocities[pin.particle]));
    }
}

TEST_P(LinearSolvers, KeepLinearMomentum) {
    // By their exact mean motion, converged or not.
    Cloth cloth = crumpled(sheet(9, 8), 0.02f, 60.0f);
    const Solved found = solve(cloth, GetParam().few);
    Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
    double mass = 0, moved = 0;
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        const double m = static_cast<double>(cloth.mass(i));
        const Eigen::Vector3d change = found.change.segment<3>(3 * static_cast<Eigen::Index>(i));
        momentum += m * (change - Eigen::Vector3d(0, -9.81 / 60, 0));
        mass += m;
        moved += m * change.norm();
    }
    EXPECT_GT(moved, 0.1 * mass) << "or the test says nothing";
    EXPECT_LT(momentum.norm(), 1e-5 * moved);
}

// The smaller the cells, the stiffer springs are beside the particles' weights, and the fewer of its waves an
// iteration solves: conjugate gradients once held a sheet of 1 cm in mid-air.
TEST_P(LinearSolvers, LetClothOfAnySizeFallFreely) {
    constexpr float h = 1.0f / 60;
    constexpr int steps = 30;
    for (const float side : {1.0f, 0.1f, 0.01f}) {
        Mesh mesh = make_sheet({.rows = 20, .columns = 20, .u = {side, 0, 0}, .v = {0, 0, side}}).value();
        std::mt19937 random(5);
        std::uniform_real_distribution<float> offset(-0.005f * side, 0.005f * side);
        for (Vec3& x : mesh.positions) x.y += offset(random);
        WorldSettings still;
        still.wind.air_density = 0;
        World world = World::create(still).value();
        ClothSettings settings;
        settings.method = GetParam().few;
        settings.air_damping = 0;
        const ClothId id = world.add_cloth(mesh, settings).value();
        for (int k = 0; k < steps; ++k) world.step(h);
        const ClothView cloth = world.cloth(id).value();
        double momentum = 0, mass = 0;
        for (std::size_t i = 0; i < cloth.positions.size(); ++i) {
            const double m = 1 / static_cast<double>(cloth.positions[i].w);
            momentum += m * static_cast<double>(cloth.velocities[i].y);
            mass += m;
        }
        const double fallen = -9.81 * steps * static_cast<double>(h);
        EXPECT_NEAR(momentum / mass, fallen, 1e-3) << "a sheet of " << side << " m";
    }
}

TEST_P(LinearSolvers, StayFiniteAtAnyStiffness) {
    for (const float stiffness : {0.0f, 1.0f, 1e6f, 1e10f}) {
        Cloth cloth = crumpled(irregular(), 0.04f, stiffness);
        cloth.pin(0);
        for (const Method& method : {GetParam().few, GetParam().many}) {
            const Solved found = solve(cloth, method);
            EXPECT_TRUE(found.change.allFinite()) << stiffness;
            EXPECT_TRUE(std::isfinite(found.residual)) << stiffness;
        }
    }
}

TEST_P(LinearSolvers, FindNothingWhereNothingActs) {
    Cloth cloth = crumpled(sheet(5, 5), 0.0f, 60.0f);
    for (Vec4& v : cloth.state.velocities.span()) v = {};
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) cloth.pin(i);
    const Solved found = solve(cloth, GetParam().many);
    EXPECT_EQ(found.change.norm(), 0);
    EXPECT_EQ(found.residual, 0);
}

/// The highest speed that is left after a second of a stiff, flat sheet whose particles start with noise,
/// relative to that after the first step.
double noise_left(const Method& method) {
    WorldSettings world_settings;
    world_settings.gravity = {0, 0, 0};
    world_settings.threads = 1;
    world_settings.wind.air_density = 0;
    World world = World::create(world_settings).value();
    Mesh mesh = sheet(12, 12);
    mesh.pattern = mesh.texcoords;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> offset(-1e-4f, 1e-4f);
    for (Vec3& x : mesh.positions) x = {x.x + offset(random), 0, x.z + offset(random)};
    ClothSettings settings;
    settings.fabric = {.warp = 4e4f, .weft = 4e4f, .shear = 0, .bending = 0, .damping = 0};
    settings.air_damping = 0;
    settings.method = method;
    (void)world.add_cloth(mesh, settings).value();
    world.step(1.0f / 60);
    const float first = world.report().peak_speed;
    for (int k = 0; k < 60; ++k) world.step(1.0f / 60);
    return static_cast<double>(world.report().peak_speed / first);
}

TEST(Chebyshev, NeverSetsStiffClothBuzzing) {
    // Every count of iterations damps noise: the fourfold reduction is for that.
    for (const int iterations : {1, 2, 3, 4, 7, 8, 16, 31}) {
        EXPECT_LT(noise_left(Chebyshev{.iterations = iterations}), 0.5) << iterations;
    }
}

}  // namespace
}  // namespace weft::test
