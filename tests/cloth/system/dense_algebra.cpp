#include "dense_algebra.h"

#include <Eigen/Dense>

namespace weft::test {

namespace {

Eigen::VectorXd solve(const Eigen::LDLT<Eigen::MatrixXd>& factors, const Eigen::VectorXd& b) {
    return factors.solve(b);
}

}  // namespace

Eigen::VectorXd solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
    return solve(a.ldlt(), b);
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& a) {
    const Eigen::LDLT<Eigen::MatrixXd> factors(a);
    Eigen::MatrixXd inverse(a.rows(), a.cols());
    for (Eigen::Index c = 0; c < a.cols(); ++c)
        inverse.col(c) = solve(factors, Eigen::VectorXd::Unit(a.rows(), c));
    return inverse;
}

Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric) {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

double largest_eigenvalue_of_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(a, b,
                                                                     Eigen::ABx_lx | Eigen::EigenvaluesOnly)
        .eigenvalues()
        .maxCoeff();
}

Modes modes(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(a, b);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

SingularValues singular_values(const Eigen::Matrix3d& a) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return {svd.matrixU(), svd.matrixV(), svd.singularValues()};
}

}  // namespace weft::test
