// Levels, Galerkin operators and the cycle against dense algebra.

#include "cloth/solver/levels/multigrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cloth/equation/sparse/vectors.h"
#include "cloth/methods/linear/conjugate_gradient.h"
#include "tests/cloth/air/waving.h"
#include "tests/cloth/system/dense_algebra.h"
#include "tests/laid_out.h"

namespace weft::test {
namespace {

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
        prolong_from(levels.serial, {p, coarse.span()}, prolonged.span());
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
        const Cloth cloth = waving(mesh, {{0, 1}});
        const Levels levels(cloth);
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
            levels.multigrid->cycle(levels.serial, r.span(), z.span());
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
    LaidOut<CgVectors> vectors(cloth.model.particle_count);
    for (int k = 1; k < 100; ++k) {
        AlignedBuffer<Vec4> dv(cloth.model.particle_count);
        const CgResult left = conjugate_gradients(
            levels.serial, *levels.system, k + 1,
            [&](auto r, auto z) { levels.multigrid->cycle(levels.serial, r, z); }, vectors, dv.span());
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

TEST(Multigrid, CostsWhatItsParticlesCostHoweverManyComponents) {
    const auto bytes_a_particle = [&](std::uint32_t side, std::uint32_t count) {
        const Cloth cloth = waving(many(loose_sheet(side, side), count), {});
        const Levels levels(cloth);
        return static_cast<double>(levels.multigrid->bytes()) / (count * side * side);
    };
    for (const std::uint32_t side : {2u, 4u, 12u}) {  // the largest have a level of 16 nodes
        const double one = bytes_a_particle(side, 1), most = bytes_a_particle(side, 5000 / (side * side));
        EXPECT_LT(bytes_a_particle(side, 200 / side), 1.05 * one) << side;
        EXPECT_LT(most, 1.05 * one) << side;
        EXPECT_LT(most, 760) << side;
    }
    EXPECT_LT(bytes_a_particle(2, 5000), 1.01 * bytes_a_particle(2, 1000));
}

TEST(Multigrid, ComponentsHaveTheLevelsThatTheyWouldHaveAlone) {
    const Mesh alone = loose_sheet(20, 23);
    const Mesh mixed = joined(alone, many(loose_sheet(2, 2), 300), {0, 3, 0});
    const Cloth of_alone = waving(alone, {{0}}), of_mixed = waving(mixed, {{0}});
    const Levels one(of_alone), all(of_mixed);
    const Interpolation &p = one.multigrid->level(0).interpolation(),
                        &q = all.multigrid->level(0).interpolation();
    ASSERT_GT(q.coarse, p.coarse);
    for (std::uint32_t c = 0; c < p.coarse; ++c) EXPECT_EQ(p.kept[c], q.kept[c]);
    for (std::uint32_t e = 0; e < Interpolation::width * p.fine; ++e) {
        EXPECT_EQ(p.nodes[e], q.nodes[e]);
        EXPECT_NEAR(p.weights[e], q.weights[e], 1e-6f);
    }
}

}  // namespace
}  // namespace weft::test
