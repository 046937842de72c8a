// Conjugate gradients: exactness, optimality, and where they end.

#include "cloth/methods/linear/conjugate_gradient.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cloth/methods/linear/chebyshev.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"
#include "tests/cloth/system/dense_algebra.h"
#include "tests/laid_out.h"

namespace weft::test {
namespace {

struct GradientProblem {
    explicit GradientProblem(Cloth of, float h = 1.0f / 60)
        : cloth(std::move(of)),
          system(assembled(cloth, h)),
          reference(dense(*system)),
          exact(solution(reference.matrix, reference.right_side)),
          dv(cloth.model.particle_count),
          vectors(cloth.model.particle_count) {}

    /// By the block diagonal, or by any other preconditioner.
    float solve(int iterations) {
        return solve(iterations, [&](std::span<const Vec4> r, std::span<Vec4> z) {
            system->precondition(serial, r, 1.0f, z);
        });
    }
    template <class Precondition>
    float solve(int iterations, const Precondition& precondition) {
        std::ranges::fill(dv.span(), Vec4{});
        return conjugate_gradients(serial, *system, iterations, precondition, vectors, dv.span()).left;
    }
    /// Of dv, in the energy norm, relative to that of dv = 0.
    [[nodiscard]] double error() const {
        const Eigen::VectorXd e = flat(dv.span()) - exact;
        return std::sqrt(e.dot(reference.matrix * e) / exact.dot(reference.matrix * exact));
    }

    Parallel serial{1};
    Cloth cloth;
    std::unique_ptr<ImplicitSystem> system;
    DenseSystem reference;
    Eigen::VectorXd exact;
    AlignedBuffer<Vec4> dv;
    LaidOut<CgVectors> vectors;
};

TEST(ConjugateGradient, IsExactAfterAsManyStepsAsUnknowns) {
    Cloth cloth = crumpled(fan(4), 0.1f, 200.0f);
    cloth.pin(0);
    const int unknowns = 3 * static_cast<int>(cloth.state.size() - 1);
    GradientProblem problem(std::move(cloth));
    problem.solve(unknowns);
    EXPECT_LT(problem.error(), 1e-5);
    problem.solve(3);
    EXPECT_GT(problem.error(), 1e-4) << "or the system was too simple to say anything";
}

TEST(ConjugateGradient, ErrorFallsMonotonicallyInTheEnergyNorm) {
    Cloth cloth = crumpled(sheet(7, 6), 0.03f, 500.0f);
    cloth.pin(3);
    GradientProblem problem(std::move(cloth));
    double before = 1;
    for (int k = 1; k <= 60; ++k) {
        problem.solve(k);
        EXPECT_LE(problem.error(), before * (1 + 1e-6) + 1e-6) << k;
        before = problem.error();
    }
    EXPECT_LT(before, 1e-2);
}

TEST(ConjugateGradient, IsTheBestOfItsKrylovSpace) {
    // Chebyshev's iterate lies in the same space, after one multiplication less.
    GradientProblem problem(crumpled(sheet(7, 6), 0.03f, 500.0f));
    AlignedBuffer<Vec4> dv(problem.dv.size());
    AlignedBuffer<Vec4> scratch(dv.size());
    for (const int k : {2, 4, 8, 16}) {
        problem.solve(k);
        const double best = problem.error();
        solve_chebyshev(problem.serial, *problem.system, k - 1, chebyshev_interval(k - 1, 1e-3),
                        scratch.span(), problem.dv.span());
        EXPECT_LT(best, problem.error()) << k;
    }
}

TEST(ConjugateGradient, TakesAnyPreconditionerAndNeedsOneStepOfTheExactOne) {
    Cloth cloth = crumpled(sheet(6, 6), 0.03f, 500.0f);
    cloth.pin(0);
    GradientProblem problem(std::move(cloth));
    const auto exactly = [&](std::span<const Vec4> r, std::span<Vec4> z) {
        const Eigen::VectorXf exact = solution(problem.reference.matrix, flat(r)).cast<float>();
        for (std::size_t i = 0; i < z.size(); ++i) {
            z[i] = to_vec4(exact.segment<3>(3 * static_cast<Eigen::Index>(i)), 0);
        }
    };
    problem.solve(1, exactly);
    EXPECT_LT(problem.error(), 1e-5);
}

TEST(ConjugateGradient, EndsWhereNothingIsLeft) {
    Cloth cloth = crumpled(sheet(5, 5), 0.03f, 60.0f);
    GradientProblem problem(std::move(cloth));
    int preconditioned = 0;
    const float residual = problem.solve(100000, [&](std::span<const Vec4> r, std::span<Vec4> z) {
        ++preconditioned;
        problem.system->precondition(problem.serial, r, 1.0f, z);
    });
    EXPECT_LT(preconditioned, 300);
    EXPECT_LT(residual, 1e-6f);
    EXPECT_LT(problem.error(), 1e-5);

    std::ranges::fill(problem.system->right_side().span(), Vec4{0, 0, 0, 1});
    EXPECT_EQ(problem.solve(10), 0);
    EXPECT_EQ(flat(problem.dv.span()).norm(), 0);
}

TEST(ConjugateGradient, LeavesTheClothAloneWhereTheSystemIsNotANumber) {
    GradientProblem problem(crumpled(sheet(5, 5), 0.03f, 60.0f));
    problem.system->right_side()[12].x = std::numeric_limits<float>::quiet_NaN();
    problem.solve(10);
    EXPECT_EQ(flat(problem.dv.span()).norm(), 0);
}

TEST(ConjugateGradient, ReportsThePreconditionedResidualOfTheLastIterateButOne) {
    GradientProblem problem(crumpled(sheet(5, 5), 0.03f, 200.0f));
    const auto preconditioned = [&](const Eigen::VectorXd& r) {
        return (dense_preconditioner(*problem.system) * r).norm();
    };
    for (int k = 2; k <= 12; ++k) {
        problem.solve(k - 1);
        const Eigen::VectorXd left =
            problem.reference.right_side - problem.reference.matrix * flat(problem.dv.span());
        EXPECT_NEAR(static_cast<double>(problem.solve(k)),
                    preconditioned(left) / preconditioned(problem.reference.right_side), 1e-4)
            << k;
    }
}

}  // namespace
}  // namespace weft::test
