#include "dense_algebra.h"

#include <Eigen/Dense>

namespace weft::test {

namespace {

double largest(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, int kind) {
    return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(a, b, kind | Eigen::EigenvaluesOnly)
        .eigenvalues()
        .maxCoeff();
}

}  // namespace

Eigen::VectorXd solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
    return a.ldlt().solve(b);
}

Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric) {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

double largest_eigenvalue_of_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return largest(a, b, Eigen::ABx_lx);
}

double largest_generalised_eigenvalue(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return largest(a, b, Eigen::Ax_lBx);
}

}  // namespace weft::test
