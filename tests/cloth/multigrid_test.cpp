// Levels, Galerkin operators, the cycle and the multilevel solver against dense algebra and their own
// promises.

#include "cloth/solvers/multigrid/multigrid.h"
#include "cloth/solvers/make_system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cloth/solvers/linear/conjugate_gradient.h"
#include "cloth/solvers/multigrid/multilevel.h"
#include "cloth/system/sparse/vectors.h"
#include "dense_algebra.h"
#include "fixtures.h"
#include "meshes.h"

namespace weft::test {
namespace {

constexpr float h = 1.0f / 60;

ClothSettings stiff(float stretch = 400) {
    ClothSettings settings;
    settings.fabric = {
        .areal_density = 0.2f, .stretch = stretch, .shear = 0.25f * stretch, .bend = 0.01f * stretch};
    return settings;
}

/// A cloth of game stiffness, out of its plane and moving smoothly.
Cloth waving(const Mesh& mesh, std::span<const std::uint32_t> pins, const ClothSettings& settings = stiff()) {
    Cloth cloth(cook(mesh).value(), settings);
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        Vec4& x = cloth.state.positions[i];
        cloth.state.velocities[i] = {0.3f * std::sin(5 * x.z), -1 + 0.5f * std::cos(4 * x.x), 0.2f * x.x, 0};
        x.y += 0.02f * std::sin(9 * x.x + 4 * x.z);
        x.x += 0.01f * std::sin(7 * x.z);
    }
    for (const std::uint32_t pin : pins) cloth.pin(pin);
    return cloth;
}

/// A cloth's system about where inertia leads, and its levels.
struct Levels {
    explicit Levels(const Cloth& cloth) : system(make_system(cloth.model, cloth.settings)) {
        system->linearise(serial, equation_of(cloth, h), cloth.state.velocities.span(),
                          LinearisedAbout::iterate);
        multigrid = std::make_unique<Multigrid>(serial, *system, cloth.state.positions.span());
        multigrid->build(serial, *system);
    }
    Parallel serial{1};
    std::unique_ptr<ImplicitSystem> system;
    std::unique_ptr<Multigrid> multigrid;
};

class OnMeshes : public testing::TestWithParam<Mesh (*)()> {
  protected:
    Cloth cloth = waving(GetParam()(), {{0, 1}});
    Levels levels{cloth};
};
INSTANTIATE_TEST_SUITE_P(All, OnMeshes,
                         testing::Values([] { return sheet(13, 17); }, [] { return loose_sheet(14, 12); },
                                         [] { return sphere(2); }, [] { return tube(9, 14); },
                                         [] {
                                             return joined(loose_sheet(9, 8), loose_sheet(7, 9), {0, 1, 0});
                                         }));

TEST_P(OnMeshes, InterpolationKeepsTranslationsAndKeptNodes) {
    for (std::size_t k = 0; k < levels.multigrid->levels(); ++k) {
        const Interpolation& p = levels.multigrid->level(k).interpolation();
        EXPECT_LT(p.coarse, p.fine);
        for (std::uint32_t i = 0; i < p.fine; ++i) {
            const float* row = &p.weights[Interpolation::width * i];
            EXPECT_NEAR(std::accumulate(row, row + Interpolation::width, 0.0f), 1.0f, 1e-5f) << "row " << i;
            for (std::uint32_t w = 0; w < Interpolation::width; ++w) EXPECT_GE(row[w], 0.0f);
        }
        for (std::uint32_t c = 0; c < p.coarse; ++c) {
            const std::uint32_t kept = p.kept[c];
            EXPECT_EQ(p.nodes[Interpolation::width * kept], c);
            EXPECT_EQ(p.weights[Interpolation::width * kept], 1.0f);
        }
    }
}

TEST_P(OnMeshes, EveryComponentHasACoarseNode) {
    const Interpolation& p = levels.multigrid->level(0).interpolation();
    const auto& offsets = cloth.model.component_offsets;
    for (std::size_t c = 0; c + 1 < offsets.size(); ++c) {
        const auto members =
            std::span(cloth.model.component_particles).subspan(offsets[c], offsets[c + 1] - offsets[c]);
        EXPECT_TRUE(std::ranges::any_of(
            members, [&](std::uint32_t i) { return std::ranges::binary_search(p.kept, i); }));
    }
}

Eigen::MatrixXd dense_interpolation(const Interpolation& p) {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(3 * p.fine, 3 * p.coarse);
    for (std::uint32_t i = 0; i < p.fine; ++i) {
        for (std::uint32_t e = Interpolation::width * i; e < Interpolation::width * (i + 1); ++e)
            result.block<3, 3>(3 * i, 3 * p.nodes[e]) +=
                static_cast<double>(p.weights[e]) * Eigen::Matrix3d::Identity();
    }
    return result;
}

TEST_P(OnMeshes, TransfersAreTheInterpolationAndItsTranspose) {
    for (std::size_t k = 0; k < levels.multigrid->levels(); ++k) {
        const Interpolation& p = levels.multigrid->level(k).interpolation();
        const Eigen::MatrixXd dense = dense_interpolation(p);
        const AlignedBuffer<Vec4> fine = random_rows(p.fine, 1, 3), coarse = random_rows(p.coarse, 1, 4);
        AlignedBuffer<Vec4> restricted(p.coarse), prolonged = random_rows(p.fine, 1, 3);
        restrict_to(levels.serial, p, fine.span(), restricted.span());
        prolong_from(levels.serial, {p, p.weights.span(), coarse.span()}, prolonged.span());
        EXPECT_LE((flat(restricted.span()) - dense.transpose() * flat(fine.span())).cwiseAbs().maxCoeff(),
                  1e-5);
        EXPECT_LE(
            (flat(prolonged.span()) - flat(fine.span()) - dense * flat(coarse.span())).cwiseAbs().maxCoeff(),
            1e-5);
    }
}

/// W of a coarse level, by multiplying unit vectors.
Eigen::MatrixXd dense_matrix(const CoarseMatrix& matrix) {
    const std::uint32_t n = matrix.stencil.nodes;
    AlignedBuffer<Vec4> unit(n), zero(n), product(n);
    Eigen::MatrixXd result(3 * n, 3 * n);
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t axis = 0; axis < 3; ++axis) {
            unit[i] = to_vec4(Vector3::Unit(axis), 0);
            for (std::uint32_t block = 0; block < block_count(n); ++block) {
                const BlockRange range{block * block_size, std::min(n, (block + 1) * block_size), block};
                subtract_product_block(matrix, range, zero.data(), unit.data(), product.data());
            }
            result.col(3 * i + axis) = -flat(product.span());
        }
        unit[i] = {};
    }
    return result;
}

/// Of matrices of 3 x 3 blocks, relative to the second.
double difference_off_the_diagonal(const Eigen::MatrixXd& found, const Eigen::MatrixXd& expected) {
    double error = 0, size = 0;
    for (Eigen::Index i = 0; i < found.rows(); i += 3) {
        for (Eigen::Index j = 0; j < found.cols(); j += 3) {
            if (i == j) continue;
            error += (found.block<3, 3>(i, j) - expected.block<3, 3>(i, j)).squaredNorm();
            size += expected.block<3, 3>(i, j).squaredNorm();
        }
    }
    return std::sqrt(error / size);
}

TEST_P(OnMeshes, CoarseSpringsAreGalerkinsProduct) {
    // Off the diagonal P^T W P has springs between free particles alone: inertia and springs to pins are
    // lumped.
    Eigen::MatrixXd springs = dense(*levels.system).matrix;
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        const bool pinned = cloth.state.positions[i].w == 0;
        auto diagonal = springs.block<3, 3>(3 * i, 3 * i);
        diagonal.setZero();
        for (std::uint32_t j = 0; j < cloth.state.size(); ++j) {
            if (j == i) continue;
            auto block = springs.block<3, 3>(3 * i, 3 * j);
            if (!block.isZero() && levels.system->is_minor(i, j)) block.setZero();
            if (!pinned) diagonal -= block;
        }
    }
    const Eigen::MatrixXd p = dense_interpolation(levels.multigrid->level(0).interpolation());
    const Eigen::MatrixXd product = p.transpose() * springs * p;
    const Eigen::MatrixXd coarse = dense_matrix(levels.multigrid->level(0).matrix());
    EXPECT_LT(difference_off_the_diagonal(coarse, product), 1e-3) << "factors below 1e-4 are left out";
    EXPECT_LT((coarse - coarse.transpose()).norm(), 1e-5 * coarse.norm());
    EXPECT_GT(eigenvalues(coarse)[0], 0);
}

// Springs and what holds nodes apart: rows of springs sum to 0, so that the sum of a row of W is what holds
// its node, and this is lumped.
TEST(Multigrid, CoarserLevelsAreSumsOfFinerOnes) {
    for (const Mesh& mesh : {sheet(30, 21), loose_sheet(28, 20), sphere(3)}) {
        const Levels levels(waving(mesh, {{0, 1}}));
        ASSERT_GE(levels.multigrid->levels(), 2u);
        for (std::size_t k = 1; k < levels.multigrid->levels(); ++k) {
            const Eigen::MatrixXd p = dense_interpolation(levels.multigrid->level(k).interpolation());
            const Eigen::MatrixXd finer = dense_matrix(levels.multigrid->level(k - 1).matrix());
            const Eigen::MatrixXd coarser = dense_matrix(levels.multigrid->level(k).matrix());
            const auto held = [](const Eigen::MatrixXd& w) -> Eigen::MatrixXd {
                return w * Eigen::Matrix3d::Identity().replicate(w.cols() / 3, 1);
            };
            const Eigen::MatrixXd finer_held = held(finer);
            EXPECT_LT((held(coarser) - p.transpose() * finer_held).norm(), 1e-5 * coarser.norm());
            Eigen::MatrixXd springs = finer;
            for (Eigen::Index i = 0; i < finer.rows(); i += 3)
                springs.block<3, 3>(i, i) -= finer_held.block<3, 3>(i, 0);
            EXPECT_LT(difference_off_the_diagonal(coarser, p.transpose() * springs * p), 1e-3);
        }
    }
}

TEST_P(OnMeshes, CycleIsSymmetricPositiveDefiniteAndLeavesPinsAlone) {
    const std::uint32_t n = cloth.model.particle_count;
    Eigen::MatrixXd inverse(3 * n, 3 * n);
    AlignedBuffer<Vec4> r(n), z(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t axis = 0; axis < 3; ++axis) {
            if (cloth.state.positions[i].w != 0) r[i] = to_vec4(Vector3::Unit(axis), 0);
            levels.multigrid->cycle(levels.serial, *levels.system, r.span(), z.span());
            inverse.col(3 * i + axis) = flat(z.span());
        }
        r[i] = {};
    }
    EXPECT_LT((inverse - inverse.transpose()).norm(), 1e-4 * inverse.norm());
    EXPECT_EQ(inverse.topRows(6).norm(), 0) << "particles 0 and 1 are pinned";
    const auto last = static_cast<Eigen::Index>(3 * n - 6);
    EXPECT_GT(eigenvalues(inverse.bottomRightCorner(last, last))[0], 0);
}

/// Iterations of preconditioned conjugate gradients until the residual is a hundredth.
int iterations_needed(const Cloth& cloth) {
    Levels levels(cloth);
    CgVectors vectors(cloth.model.particle_count);
    for (int k = 1; k < 100; ++k) {
        AlignedBuffer<Vec4> dv(cloth.model.particle_count);
        const CgResult left = conjugate_gradients(
            levels.serial, *levels.system, k + 1,
            [&](auto r, auto z) { levels.multigrid->cycle(levels.serial, *levels.system, r, z); }, vectors,
            dv.span());
        if (left.left < 0.01f) return k;
    }
    return 100;
}

TEST(Multigrid, NeedsFewIterationsAtAnySizeAndStiffness) {
    for (const std::uint32_t side : {12u, 24u, 48u, 96u}) {
        const std::uint32_t corners[] = {0, side - 1};
        EXPECT_LE(iterations_needed(waving(sheet(side, side), corners)), 8) << side << " a side";
    }
    const std::uint32_t corners[] = {0, 47};
    for (const float stretch : {40.0f, 4e4f, 4e6f})
        EXPECT_LE(iterations_needed(waving(sheet(48, 48), corners, stiff(stretch))), 16) << stretch << " N/m";
    EXPECT_LE(iterations_needed(waving(loose_sheet(40, 40), corners)), 12);
}

// A cycle treats all levels alike from either side: also those between the first and the last, which only
// large cloths have.
TEST(Multigrid, CyclesOfManyLevelsAreSymmetric) {
    Levels levels(waving(sheet(130, 130), {{0, 129}}));
    const std::uint32_t n = 130 * 130;
    ASSERT_GE(levels.multigrid->levels(), 3u);
    const auto smooth_rows = [&](float waves) {
        AlignedBuffer<Vec4> rows(n);
        for (std::uint32_t i = 0; i < n; ++i) {
            const float x = static_cast<float>(i % 130) / 129, y = static_cast<float>(i / 130) / 129;
            if (i != 0 && i != 129) rows[i] = {std::cos(waves * x), std::cos(waves * (x - y)), x * y, 0};
        }
        return rows;
    };
    std::vector<double> partials(block_count(n));
    const AlignedBuffer<Vec4> a = smooth_rows(3), b = smooth_rows(14);
    AlignedBuffer<Vec4> z_a(n), z_b(n);
    levels.multigrid->cycle(levels.serial, *levels.system, a.span(), z_a.span());
    levels.multigrid->cycle(levels.serial, *levels.system, b.span(), z_b.span());
    const double ab = dot(levels.serial, z_a.span(), b.span(), partials),
                 ba = dot(levels.serial, a.span(), z_b.span(), partials);
    EXPECT_NEAR(ab / ba, 1, 1e-4);
}

/// `count` meshes side by side in one.
Mesh many(const Mesh& one, std::uint32_t count) {
    Mesh result;
    const auto n = static_cast<std::uint32_t>(one.positions.size());
    for (std::uint32_t k = 0; k < count; ++k) {
        for (const Vec3& x : one.positions)
            result.positions.push_back({x.x + 2.0f * static_cast<float>(k), x.y, x.z});
        for (const Triangle& t : one.triangles)
            result.triangles.push_back({t[0] + k * n, t[1] + k * n, t[2] + k * n});
    }
    return result;
}

TEST(Multigrid, CostsWhatItsParticlesCostHoweverManyComponents) {
    const auto bytes_a_particle = [&](std::uint32_t side, std::uint32_t count) {
        const Levels levels(waving(many(loose_sheet(side, side), count), {}));
        return static_cast<double>(levels.multigrid->bytes()) / (count * side * side);
    };
    for (const std::uint32_t side : {2u, 4u, 12u}) {  // the largest have a level of 16 nodes
        const double one = bytes_a_particle(side, 1), most = bytes_a_particle(side, 5000 / (side * side));
        EXPECT_LT(bytes_a_particle(side, 200 / side), 1.05 * one) << side;
        EXPECT_LT(most, 1.05 * one) << side;
        EXPECT_LT(most, 700) << side;
    }
    EXPECT_LT(bytes_a_particle(2, 5000), 1.01 * bytes_a_particle(2, 1000));
}

TEST(Multigrid, ComponentsHaveTheLevelsThatTheyWouldHaveAlone) {
    const Mesh alone = loose_sheet(20, 23);
    const Mesh mixed = joined(alone, many(loose_sheet(2, 2), 300), {0, 3, 0});
    const Levels one(waving(alone, {{0}})), all(waving(mixed, {{0}}));
    const Interpolation &p = one.multigrid->level(0).interpolation(),
                        &q = all.multigrid->level(0).interpolation();
    ASSERT_GT(q.coarse, p.coarse);
    for (std::uint32_t c = 0; c < p.coarse; ++c) EXPECT_EQ(p.kept[c], q.kept[c]);
    for (std::uint32_t e = 0; e < Interpolation::width * p.fine; ++e) {
        EXPECT_EQ(p.nodes[e], q.nodes[e]);
        EXPECT_NEAR(p.weights[e], q.weights[e], 1e-6f);
    }
}

TEST(Multigrid, ConvergesOnManyComponentsAsOnTheLargestAlone) {
    const Mesh large = loose_sheet(30, 30);
    const int alone = iterations_needed(waving(large, {{0, 29}}));
    EXPECT_LE(iterations_needed(waving(joined(large, many(loose_sheet(2, 2), 500), {0, 3, 0}), {{0, 29}})),
              alone + 1);
    EXPECT_LE(iterations_needed(waving(joined(large, many(loose_sheet(7, 5), 60), {0, 3, 0}), {{0, 29}})),
              alone + 1);
    EXPECT_LE(iterations_needed(waving(many(loose_sheet(2, 2), 2000), {})), 8);
}

/// One step by the multilevel solver from a cloth's state.
Eigen::VectorXd stepped(Cloth& cloth, const Multilevel& method, int threads = 1) {
    cloth.settings.method = method;
    Parallel parallel(threads);
    Profiler profiler(stage_names);
    MultilevelSolver solver(cloth.model, cloth.settings, cloth.state.positions.span());
    const StepEquation equation = equation_of(cloth, h);
    solver.solve({.parallel = parallel,
                  .profiler = profiler,
                  .model = cloth.model,
                  .settings = cloth.settings,
                  .equation = equation,
                  .velocities = cloth.next_velocities.span()});
    return velocity_change(cloth);
}

TEST(MultilevelSolver, OnePassIsTheLinearisedStep) {
    const std::uint32_t corners[] = {0, 11};
    Cloth cloth = waving(sheet(12, 12), corners);
    Levels levels(cloth);
    const DenseSystem system = dense(*levels.system);
    const Eigen::VectorXd exact = solution(system.matrix, system.right_side);
    const Eigen::VectorXd found = stepped(cloth, {.passes = 1, .iterations = 60, .effort = 1});
    EXPECT_LT((found - exact).norm() / exact.norm(), 1e-4);
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
    const double one = equation_left(cloth, stepped(cloth, {.passes = 1, .iterations = 20}));
    const double many = equation_left(cloth, stepped(cloth, {.passes = 12, .iterations = 20}));
    EXPECT_GT(one, 10 * many);
    EXPECT_LT(many, 1e-3);
}

TEST(MultilevelSolver, GivesTheSameBytesForAnyNumberOfThreads) {
    const std::uint32_t corners[] = {0, 47};
    Cloth cloth = waving(sheet(48, 48), corners);
    const Eigen::VectorXd one = stepped(cloth, {.iterations = 3}, 1);
    for (const int threads : {2, 3, 8}) EXPECT_EQ(one, stepped(cloth, {.iterations = 3}, threads));
}

WorldSettings still_air() {
    WorldSettings settings;
    settings.wind.air_density = 0;
    return settings;
}

TEST(MultilevelSolver, FollowsPinsThatComeAndGo) {
    ClothSettings settings = stiff();
    settings.method = Multilevel{};
    World world = World::create(still_air()).value();
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
    EXPECT_NEAR(fall_speed(), before * kept + 9.81 / rate * (1 - kept), 0.1) << "falls freely";
    EXPECT_EQ(world.report().flags, StepFlags::none);
}

/// Positions of `count` quads that hang by a corner each, after half a second.
std::vector<Vector3> swung(std::uint32_t count) {
    ClothSettings settings = stiff();
    settings.method = Multilevel{};
    World world = World::create(still_air()).value();
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
    const auto settings_of = [](float shear, float bend) {
        ClothSettings settings = stiff();
        settings.method = Multilevel{};
        settings.fabric.shear = shear;
        settings.fabric.bend = bend;
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
            cloth.solver->solve({.parallel = serial,
                                 .profiler = profiler,
                                 .model = cloth.model,
                                 .settings = cloth.settings,
                                 .equation = equation,
                                 .velocities = cloth.next_velocities.span()});
        }
        return flat(cloth.next_velocities.span());
    };
    const ClothSettings last = settings_of(50, 2);
    const Eigen::VectorXd expected = step_after({last});
    for (const ClothSettings& before : {settings_of(1, 2), settings_of(800, 300), settings_of(0, 0)})
        EXPECT_EQ(step_after({before, last}), expected);
    const ClothSettings stiff_bending = settings_of(50, 300);
    EXPECT_EQ(step_after({last, stiff_bending}), step_after({stiff_bending}));
}

TEST(MultilevelSolver, TakesTheSmallestCloth) {
    ClothSettings settings = stiff();
    settings.method = Multilevel{};
    World world = World::create(still_air()).value();
    const ClothId id = world.add_cloth(sheet(2, 2), settings).value();
    ASSERT_TRUE(world.pin(id, 0).ok());
    for (int k = 0; k < 60; ++k) world.step(h);
    EXPECT_EQ(world.report().flags, StepFlags::none);
    EXPECT_LT(world.cloth(id)->bounds.lower.y, -0.5f);
}

}  // namespace
}  // namespace weft::test
