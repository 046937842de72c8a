#include "engine/small_matrices.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

namespace weft {

SymmetricAxes symmetric_axes(const Eigen::Matrix3d& symmetric) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(symmetric);
    return {axes.eigenvalues(), axes.eigenvectors()};
}

SingularValues singular_values(const Eigen::Matrix3d& m) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

Eigen::Vector3d solve_by_ldlt(const Eigen::Matrix3d& a, const Eigen::Vector3d& b) {
    return a.ldlt().solve(b);
}
Eigen::Vector<double, 6> solve_by_ldlt(const Eigen::Matrix<double, 6, 6>& a,
                                       const Eigen::Vector<double, 6>& b) {
    return a.ldlt().solve(b);
}
Eigen::Matrix<double, 6, 6> inverse_by_ldlt(const Eigen::Matrix<double, 6, 6>& a) {
    return a.ldlt().solve(Eigen::Matrix<double, 6, 6>::Identity());
}

Eigen::Vector3d solve_by_llt(const Eigen::Matrix3d& a, const Eigen::Vector3d& b) {
    return a.llt().solve(b);
}

}  // namespace weft
