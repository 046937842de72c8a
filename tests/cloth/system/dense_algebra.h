#pragma once
// Eigen's decompositions as plain functions: compiled once, not in every test file that compares with one.

#include <Eigen/Core>

namespace weft::test {

/// The x of a x = b for a symmetric a.
[[nodiscard]] Eigen::VectorXd solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
/// The inverse of a symmetric matrix.
[[nodiscard]] Eigen::MatrixXd inverse(const Eigen::MatrixXd& a);
/// The eigenvalues of a symmetric matrix, ascending.
[[nodiscard]] Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric);
/// The largest eigenvalue of a b, both symmetric and b positive definite.
[[nodiscard]] double largest_eigenvalue_of_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// a v = lambda b v, both symmetric and b positive definite: v^T b v = 1.
struct Modes {
    Eigen::VectorXd eigenvalues;  ///< ascending
    Eigen::MatrixXd vectors;
};
[[nodiscard]] Modes modes(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// a = u diag(s) v^T.
struct SingularValues {
    Eigen::Matrix3d u, v;
    Eigen::Vector3d s;
};
[[nodiscard]] SingularValues singular_values(const Eigen::Matrix3d& a);

}  // namespace weft::test
