#pragma once
// Decompositions of small dense matrices, in double precision. One file alone instantiates Eigen's templates
// for them: each takes seconds to compile.

#include <Eigen/Core>

namespace weft {

/// Eigenvalues, the least first, and the eigenvectors of length 1, one a column.
struct SymmetricAxes {
    Eigen::Vector3d values;
    Eigen::Matrix3d vectors;
};
[[nodiscard]] SymmetricAxes symmetric_axes(const Eigen::Matrix3d& symmetric);

/// m = u diag(values) v^T, the largest value first.
struct SingularValues {
    Eigen::Matrix3d u;
    Eigen::Vector3d values;
    Eigen::Matrix3d v;
};
[[nodiscard]] SingularValues singular_values(const Eigen::Matrix3d& m);

/// The x with a x = b, by L D L^T; a is symmetric and positive definite.
[[nodiscard]] Eigen::Vector3d solve_by_ldlt(const Eigen::Matrix3d& a, const Eigen::Vector3d& b);
[[nodiscard]] Eigen::Vector<double, 6> solve_by_ldlt(const Eigen::Matrix<double, 6, 6>& a,
                                                     const Eigen::Vector<double, 6>& b);
[[nodiscard]] Eigen::Matrix<double, 6, 6> inverse_by_ldlt(const Eigen::Matrix<double, 6, 6>& a);
/// The same by L L^T.
[[nodiscard]] Eigen::Vector3d solve_by_llt(const Eigen::Matrix3d& a, const Eigen::Vector3d& b);

}  // namespace weft
