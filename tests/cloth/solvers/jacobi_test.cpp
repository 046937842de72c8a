// Kang's solver against dense solves, and its error against theory.

#include "cloth/methods/linear/jacobi.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/simd/symmetric3.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"
#include "tests/cloth/system/dense_algebra.h"

namespace weft::test {
namespace {

/// A cloth's assembled system, and what Jacobi iterations make of it.
struct JacobiProblem {
    explicit JacobiProblem(const Cloth& cloth, float h = 1.0f / 60, const Vector3& gravity = {0, -9.81f, 0})
        : system(assembled(cloth, h, gravity)),
          dv(cloth.model.particle_count),
          scratch(cloth.model.particle_count) {}

    void solve(int iterations) {
        Parallel serial(1);
        solve_jacobi(serial, *system, iterations, scratch.span(), dv.span());
    }
    [[nodiscard]] Eigen::VectorXd solution() const { return flat(dv.span()); }

    std::unique_ptr<ImplicitSystem> system;
    AlignedBuffer<Vec4> dv, scratch;
};

/// Block Jacobi's iteration matrix G = I - D^-1 W.
Eigen::MatrixXd iteration_matrix(ImplicitSystem& system) {
    const Eigen::MatrixXd w = dense(system).matrix;
    return Eigen::MatrixXd::Identity(w.rows(), w.cols()) - dense_preconditioner(system) * w;
}

TEST(Inverse, IsTheInverseOfRandomPositiveDefiniteMatrices) {
    std::mt19937 random(1);
    std::normal_distribution<double> component;
    for (int k = 0; k < 1000; ++k) {
        const Eigen::Matrix3d root =
            Eigen::Matrix3d::NullaryExpr([&](auto, auto) { return component(random); });
        const Eigen::Matrix3d m = root * root.transpose() + 0.1 * Eigen::Matrix3d::Identity();
        const Symmetric3 stored{.xx = static_cast<float>(m(0, 0)),
                                .yy = static_cast<float>(m(1, 1)),
                                .zz = static_cast<float>(m(2, 2)),
                                .xy = static_cast<float>(m(0, 1)),
                                .xz = static_cast<float>(m(0, 2)),
                                .yz = static_cast<float>(m(1, 2))};
        const Vector3 v = Vector3::NullaryExpr([&](auto) { return static_cast<float>(component(random)); });
        const Eigen::Vector3d exact = m.inverse() * v.cast<double>();
        EXPECT_LT(((inverse(stored, 0.1f) * v).cast<double>() - exact).norm() / exact.norm(), 1e-3);
    }
}

TEST(Inverse, StaysPositiveDefiniteWhereRoundingWouldNot) {
    // One spring 1e9 times stiffer than the inertia: in float the inertia is lost against it.
    const Vector3 n = Vector3(0.3f, -0.8f, 0.5f).normalized();
    Symmetric3 m;
    m.add(1.0f, 3e4f * n);
    const Symmetric3 i = inverse(m, 1.0f);
    Eigen::Matrix3d full;
    full << static_cast<double>(i.xx), static_cast<double>(i.xy), static_cast<double>(i.xz),
        static_cast<double>(i.xy), static_cast<double>(i.yy), static_cast<double>(i.yz),
        static_cast<double>(i.xz), static_cast<double>(i.yz), static_cast<double>(i.zz);
    const Eigen::VectorXd eigenvalues = test::eigenvalues(full);
    EXPECT_GE(eigenvalues.minCoeff(), -1e-6);
    EXPECT_LE(eigenvalues.maxCoeff(), 3.0)
        << "no direction is lighter than the particle by more than rounding";
}

TEST(Jacobi, ManyIterationsEqualADenseSolve) {
    for (const std::uint32_t pinned : {0u, 3u}) {
        Cloth cloth = crumpled(sheet(6, 7), 0.03f, 60.0f);
        for (std::uint32_t p = 0; p < pinned; ++p) cloth.pin(5 * p);
        JacobiProblem problem(cloth);
        const DenseSystem system = dense(*problem.system);
        const Eigen::VectorXd exact = solution(system.matrix, system.right_side);
        problem.solve(4000);
        EXPECT_LT((problem.solution() - exact).norm() / exact.norm(), 2e-5) << pinned << " pinned";
    }
}

TEST(Jacobi, ErrorAfterKIterationsIsTheIterationMatrixToTheKPlusOne) {
    Cloth cloth = crumpled(sheet(5, 5), 0.03f, 200.0f);
    JacobiProblem problem(cloth);
    const DenseSystem system = dense(*problem.system);
    const Eigen::VectorXd exact = solution(system.matrix, system.right_side);
    const Eigen::MatrixXd g = iteration_matrix(*problem.system);
    Eigen::VectorXd error = -exact;  // of dv = 0
    for (int k = 0; k <= 16; ++k) {
        error = g * error;
        problem.solve(k);
        EXPECT_LT((problem.solution() - exact - error).norm(), 1e-5 * exact.norm()) << "k = " << k;
    }
}

TEST(Jacobi, ConvergesForAnyStiffnessAndStep) {
    // 2 D - W is positive definite whenever every K is positive semi-definite (Kang's safe derivative makes
    // it so), hence the eigenvalues of D^-1 W lie in (0, 2) and those of G in (-1, 1). W is multiplied out in
    // single precision, in which its inertia is lost beside stiff springs.
    constexpr double rounding = 1e-7;
    for (const float stiffness : {1.0f, 1e3f, 1e6f}) {
        for (const float h : {1e-4f, 1.0f / 60, 1.0f}) {
            Cloth cloth = crumpled(sheet(4, 5), 0.1f, stiffness);
            const auto system = assembled(cloth, h);
            const Eigen::MatrixXd w = dense(*system).matrix, d = inverse(dense_preconditioner(*system));
            const Eigen::VectorXd eigenvalues = modes(w, d).eigenvalues;
            EXPECT_GT(eigenvalues.minCoeff(), -rounding) << "k " << stiffness << ", h " << h;
            EXPECT_LT(eigenvalues.maxCoeff(), 2 + rounding) << "k " << stiffness << ", h " << h;
        }
    }
}

TEST(Jacobi, OddCountsNeverOverCorrectAndEvenOnesDo) {
    // k iterations apply I - G^(k+1) to the solution. G has eigenvalues near -1, on a checkerboard load: an
    // even power keeps that factor in [0, 1], an odd one brings it near 2. A factor p on a mode shows as dv .
    // W dv = p dv . b.
    Cloth cloth = crumpled(sheet(8, 8), 0.0f, 4000.0f);
    for (Vec4& v : cloth.state.velocities.span()) v = {};
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        cloth.state.positions[i].x += ((i / 8 + i % 8) % 2 == 0 ? 1e-3f : -1e-3f);
    }
    JacobiProblem problem(cloth, 1.0f / 60, Vector3::Zero());
    const DenseSystem system = dense(*problem.system);
    const auto correction = [&](int k) {
        problem.solve(k);
        const Eigen::VectorXd dv = problem.solution();
        return dv.dot(system.matrix * dv) / dv.dot(system.right_side);
    };
    for (int k = 1; k <= 15; k += 2) EXPECT_LE(correction(k), 1) << "k = " << k;
    for (int k = 0; k <= 4; k += 2) EXPECT_GT(correction(k), 1.02) << "k = " << k;
}

TEST(MeanMotion, DoesNotChangeTheConvergedSolution) {
    Cloth cloth = crumpled(sheet(5, 6), 0.03f, 60.0f);
    JacobiProblem problem(cloth);
    const DenseSystem system = dense(*problem.system);
    const Eigen::VectorXd exact = solution(system.matrix, system.right_side);
    Parallel serial(1);
    MeanMotion mean_motion(cloth.model);
    const AlignedBuffer<Vec4> at_rest(cloth.model.particle_count);
    mean_motion.take_out(serial, nullptr, problem.system->right_side().span());
    problem.solve(4000);
    mean_motion.put_back(serial, nullptr, problem.system->right_side().span(), at_rest.span(),
                         problem.dv.span());
    EXPECT_LT((problem.solution() - exact).norm() / exact.norm(), 2e-5);
}

TEST(MeanMotion, LeavesPinnedComponentsAlone) {
    const Mesh two = joined(loose_sheet(3, 3), loose_sheet(4, 4), {0, 1, 0});
    Cloth cloth = crumpled(two, 0.01f, 60.0f);
    ASSERT_EQ(cloth.model.info.components, 2u);
    cloth.pin(9);
    JacobiProblem problem(cloth);
    Parallel serial(1);
    MeanMotion mean_motion(cloth.model);
    const AlignedBuffer<Vec4> at_rest(cloth.model.particle_count);
    mean_motion.take_out(serial, nullptr, problem.system->right_side().span());
    mean_motion.put_back(serial, nullptr, problem.system->right_side().span(), at_rest.span(),
                         problem.dv.span());
    EXPECT_GT(xyz(problem.dv[0]).norm(), 0.1f) << "9.81 m/s^2 for 1/60 s";
    EXPECT_EQ(xyz(problem.dv[10]), Vector3(0, 0, 0));
}

}  // namespace
}  // namespace weft::test
