#pragma once
// Eigen's decompositions as plain functions: compiled once, not in every test file that compares with one.

#include <Eigen/Core>

namespace weft::test {

/// The x of a x = b for a symmetric a.
[[nodiscard]] Eigen::VectorXd solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
/// The eigenvalues of a symmetric matrix, ascending.
[[nodiscard]] Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric);
/// The largest eigenvalue of a b, both symmetric and b positive definite.
[[nodiscard]] double largest_eigenvalue_of_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
/// The largest lambda of a v = lambda b v, both symmetric and b positive definite.
[[nodiscard]] double largest_generalised_eigenvalue(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace weft::test
