// The set solvers against plain references in double precision.

#include "cloth/methods/positional/fibre_kernels.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/memory/aligned_buffer.h"
#include "engine/vector.h"
#include "tests/cloth/system/dense_algebra.h"

namespace weft::test {
namespace {

constexpr std::uint32_t lanes = FibreSets::lanes;

/// 16 fibres of different lengths, bent at random, some particles pinned, and with multipliers from
/// iterations before.
struct Fibres16 {
    explicit Fibres16(float kappa, float gamma = 0.2f)
        : start(particles + 1),
          moved(particles + 1),
          numbers(particles),
          weights(particles),
          rest(rows * lanes),
          compliances(rows * lanes),
          multipliers(rows * lanes),
          scratch(FibreGroup::scratch_rows * rows * lanes) {
        std::mt19937 random(3);
        std::uniform_real_distribution<float> offset(-0.4f, 0.4f), weight(0.5f, 2);
        for (std::uint32_t row = 0; row <= rows; ++row) {
            for (std::uint32_t lane = 0; lane < lanes; ++lane) {
                const std::uint32_t i = row * lanes + lane;
                const bool exists = row <= length(lane);
                numbers[i] = exists ? i : particles;
                start[i] = {static_cast<float>(row) + offset(random), offset(random), offset(random), 0};
                moved[i] = {0.3f * offset(random), 0.3f * offset(random), 0.3f * offset(random), 0};
                weights[i] = !exists || (row == 0 && lane % 3 == 0) ? 0 : weight(random);
                if (row < rows) rest[i] = row < length(lane) ? 1.0f : FibreSets::no_spring;
                if (row < length(lane)) multipliers[i] = 0.1f * offset(random);
            }
        }
        // Each spring of a fibre is of another stiffness.
        for (std::uint32_t at = 0; at < compliances.size(); ++at)
            compliances[at] = (1 + 0.1f * static_cast<float>(at % 7)) / kappa;
        group = {rows,
                 numbers.data(),
                 weights.data(),
                 rest.data(),
                 compliances.data(),
                 multipliers.data(),
                 scratch.data(),
                 gamma,
                 start.data(),
                 moved.data()};
    }

    static std::uint32_t length(std::uint32_t lane) { return rows - lane / 2; }
    [[nodiscard]] Eigen::Vector3d displacement(std::uint32_t row, std::uint32_t lane) const {
        return xyz(moved[row * lanes + lane]).cast<double>();
    }
    [[nodiscard]] Eigen::Vector3d position(std::uint32_t row, std::uint32_t lane) const {
        return xyz(start[row * lanes + lane]).cast<double>() + displacement(row, lane);
    }
    [[nodiscard]] double weight(std::uint32_t row, std::uint32_t lane) const {
        return static_cast<double>(weights[row * lanes + lane]);
    }
    [[nodiscard]] double multiplier(std::uint32_t row, std::uint32_t lane) const {
        return static_cast<double>(multipliers[row * lanes + lane]);
    }

    static constexpr std::uint32_t rows = 12, particles = (rows + 1) * lanes;
    AlignedBuffer<Vec4> start, moved;
    AlignedBuffer<std::uint32_t> numbers;
    AlignedBuffer<float> weights, rest, compliances, multipliers, scratch;
    FibreGroup group{};
};

/// Positions after dense solves of (J W J^T (1 + gamma) + alpha) dlambda = -C - gamma J u - alpha lambda.
Eigen::MatrixXd densely_solved(const Fibres16& fibres, std::uint32_t lane) {
    const std::uint32_t n = Fibres16::length(lane);
    const double gamma = static_cast<double>(fibres.group.gamma);
    const auto compliance = [&](std::uint32_t row) {
        return static_cast<double>(fibres.compliances[row * lanes + lane]);
    };
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(n, 3 * (n + 1)),
                    weights = Eigen::MatrixXd::Zero(3 * (n + 1), 3 * (n + 1));
    Eigen::VectorXd right(n), displacements(3 * (n + 1)), positions(3 * (n + 1));
    for (std::uint32_t row = 0; row <= n; ++row) {
        weights.block<3, 3>(3 * row, 3 * row) = fibres.weight(row, lane) * Eigen::Matrix3d::Identity();
        displacements.segment<3>(3 * row) = fibres.displacement(row, lane);
        positions.segment<3>(3 * row) = fibres.position(row, lane);
    }
    for (std::uint32_t row = 0; row < n; ++row) {
        const Eigen::Vector3d d = fibres.position(row + 1, lane) - fibres.position(row, lane);
        jacobian.block<1, 3>(row, 3 * row) = -d.normalized().transpose();
        jacobian.block<1, 3>(row, 3 * row + 3) = d.normalized().transpose();
        right[row] = -(d.norm() - 1) - compliance(row) * fibres.multiplier(row, lane);
    }
    right -= gamma * jacobian * displacements;
    Eigen::MatrixXd matrix = (1 + gamma) * jacobian * weights * jacobian.transpose();
    for (std::uint32_t row = 0; row < n; ++row) matrix(row, row) += compliance(row);
    return positions + weights * jacobian.transpose() * solution(matrix, right);
}

TEST(FibreLdlt, EqualsADenseSolve) {
    for (const float kappa : {0.01f, 1.0f, 100.0f}) {
        Fibres16 fibres(kappa);
        std::vector<Eigen::MatrixXd> expected;
        for (std::uint32_t lane = 0; lane < lanes; ++lane) expected.push_back(densely_solved(fibres, lane));
        solve_by_ldlt(fibres.group);
        for (std::uint32_t lane = 0; lane < lanes; ++lane)
            for (std::uint32_t row = 0; row <= Fibres16::length(lane); ++row)
                EXPECT_LT((fibres.position(row, lane) - expected[lane].block<3, 1>(3 * row, 0)).norm(), 1e-4)
                    << "kappa " << kappa << ", row " << row << ", lane " << lane;
    }
}

TEST(FibreLdlt, KeepsLinearAndAngularMomentum) {
    Fibres16 fibres(50);
    std::vector<Eigen::Vector3d> before;
    for (std::uint32_t i = 0; i < Fibres16::particles; ++i)
        before.push_back(fibres.position(i / lanes, i % lanes));
    solve_by_ldlt(fibres.group);
    for (std::uint32_t lane = 0; lane < lanes; ++lane) {
        if (fibres.weight(0, lane) == 0) continue;  // pinned
        Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = linear;
        double moved = 0;
        for (std::uint32_t row = 0; row <= Fibres16::length(lane); ++row) {
            const Eigen::Vector3d change =
                (fibres.position(row, lane) - before[row * lanes + lane]) / fibres.weight(row, lane);
            linear += change;
            angular += before[row * lanes + lane].cross(change);
            moved += change.norm();
        }
        EXPECT_GT(moved, 0.1);
        EXPECT_LT(linear.norm(), 2e-6 * moved);
        EXPECT_LT(angular.norm(), 2e-5 * moved) << "about the origin, 12 m away";
    }
}

TEST(FibreGaussSeidel, EqualsAPlainLoop) {
    Fibres16 fibres(3);
    std::vector<Eigen::Vector3d> x, start;
    for (std::uint32_t i = 0; i < Fibres16::particles; ++i) {
        x.push_back(fibres.position(i / lanes, i % lanes));
        start.push_back(xyz(fibres.start[i]).cast<double>());
    }
    const double gamma = static_cast<double>(fibres.group.gamma);
    for (std::uint32_t lane = 0; lane < lanes; ++lane) {
        for (std::uint32_t row = 0; row < Fibres16::length(lane); ++row) {
            const std::uint32_t a = row * lanes + lane, b = a + lanes;
            const Eigen::Vector3d d = x[b] - x[a], n = d.normalized();
            const double stretched_by = n.dot(d - (start[b] - start[a]));
            const double weight = fibres.weight(row, lane) + fibres.weight(row + 1, lane);
            const double compliance = static_cast<double>(fibres.compliances[a]);
            const double change =
                (-(d.norm() - 1) - gamma * stretched_by - compliance * fibres.multiplier(row, lane)) /
                ((1 + gamma) * weight + compliance);
            x[a] -= fibres.weight(row, lane) * change * n;
            x[b] += fibres.weight(row + 1, lane) * change * n;
        }
    }
    solve_by_gauss_seidel(fibres.group);
    for (std::uint32_t lane = 0; lane < lanes; ++lane)
        for (std::uint32_t row = 0; row <= Fibres16::length(lane); ++row)
            EXPECT_LT((fibres.position(row, lane) - x[row * lanes + lane]).norm(), 1e-5);
}

TEST(FibreLdlt, MovesNoParticleBeyondItsFibresViolations) {
    // Straight, all but rigid, and pinned at both ends nearer than it is long: no solution nearby.
    Fibres16 fibres(1e9f, 0);
    for (std::uint32_t i = 0; i < Fibres16::particles; ++i) {
        const std::uint32_t row = i / lanes;
        fibres.numbers[i] = i;
        fibres.start[i] = {0.9f * static_cast<float>(row), 0, 0, 0};
        fibres.moved[i] = {};
        fibres.weights[i] = row == 0 || row == Fibres16::rows ? 0.0f : 1.0f;
    }
    for (float& length : fibres.rest.span()) length = 1;
    for (float& multiplier : fibres.multipliers.span()) multiplier = 0;
    for (int k = 0; k < 20; ++k) solve_by_ldlt(fibres.group);
    for (std::uint32_t i = 0; i < Fibres16::particles; ++i)
        EXPECT_LT(fibres.displacement(i / lanes, i % lanes).norm(), 20 * 0.1 * Fibres16::rows);
}

}  // namespace
}  // namespace weft::test
