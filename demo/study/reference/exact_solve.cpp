#include "demo/study/reference/exact_solve.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/vector.h"

namespace weft::study {

BlockMatrix::BlockMatrix(std::uint32_t particles, std::span<const ParticlePair> pairs)
    : lower_(3 * static_cast<int>(particles), 3 * static_cast<int>(particles)) {
    std::vector<Eigen::Triplet<double, int>> entries;
    for (std::uint32_t i = 0; i < particles; ++i) {
        const int at = 3 * static_cast<int>(i);
        for (int c = 0; c < 3; ++c)
            for (int r = c; r < 3; ++r) entries.emplace_back(at + r, at + c, 0.0);
    }
    for (const auto& [i, j] : pairs) {
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r)
                entries.emplace_back(3 * static_cast<int>(j) + r, 3 * static_cast<int>(i) + c, 0.0);
    }
    lower_.setFromTriplets(entries.begin(), entries.end());
    lower_.makeCompressed();
    for (const auto& [i, j] : pairs) {
        std::array<int, 3> at{};
        for (int c = 0; c < 3; ++c) {
            const int column = 3 * static_cast<int>(i) + c;
            const int* const begin = lower_.innerIndexPtr() + lower_.outerIndexPtr()[column];
            const int* const end = lower_.innerIndexPtr() + lower_.outerIndexPtr()[column + 1];
            const int* const row = std::lower_bound(begin, end, 3 * static_cast<int>(j));
            at[static_cast<std::size_t>(c)] = static_cast<int>(row - lower_.innerIndexPtr());
        }
        pair_values_.push_back(at);
    }
}

void BlockMatrix::set_zero() {
    std::fill_n(lower_.valuePtr(), lower_.nonZeros(), 0.0);
}

// The diagonal block's lower part comes first in each of its columns.
void BlockMatrix::add_diagonal(std::uint32_t particle, const Eigen::Matrix3d& block) {
    for (int c = 0; c < 3; ++c) {
        double* const column = lower_.valuePtr() + lower_.outerIndexPtr()[3 * static_cast<int>(particle) + c];
        for (int r = c; r < 3; ++r) column[r - c] += block(r, c);
    }
}

void BlockMatrix::add_pair(std::size_t pair, const Eigen::Matrix3d& block) {
    for (int c = 0; c < 3; ++c) {
        double* const column = lower_.valuePtr() + pair_values_[pair][static_cast<std::size_t>(c)];
        for (int r = 0; r < 3; ++r) column[r] += block(r, c);
    }
}

namespace {

// Hestenes and Stiefel 1952. The preconditioned direction is made conjugate by the formula of Polak and
// Ribiere, which tolerates a preconditioner that rounds (Golub and Ye 1999).
bool conjugate_gradients(const BlockMatrix::Sparse& matrix, const Eigen::VectorXd& b, double tolerance,
                         const Preconditioner& precondition, Eigen::VectorXd& x) {
    x.setZero(b.size());
    Eigen::VectorXd r = b, r_before, z, product(b.size());
    precondition(r, z);
    Eigen::VectorXd p = z;
    double rz = r.dot(z);
    const double enough = tolerance * b.norm();
    for (int iterations = 0; r.norm() > enough && iterations < 10'000; ++iterations) {
        product.noalias() = matrix.selfadjointView<Eigen::Lower>() * p;
        const double curvature = p.dot(product);
        const double step = r.dot(p) / std::abs(curvature);
        x += step * p;
        if (!(curvature > 0)) return false;
        r_before = r;
        r -= step * product;
        precondition(r, z);
        const double conjugate = z.dot(r - r_before) / std::exchange(rz, r.dot(z));
        p = z + conjugate * p;
    }
    return true;
}

}  // namespace

bool ExactSolve::solve(const BlockMatrix& matrix, const Eigen::VectorXd& b, double tolerance,
                       const Preconditioner& precondition, Eigen::VectorXd& x) {
    return is_direct_ ? factorise(matrix.lower(), b, x)
                      : conjugate_gradients(matrix.lower(), b, tolerance, precondition, x);
}

bool ExactSolve::factorise(const Sparse& matrix, const Eigen::VectorXd& b, Eigen::VectorXd& x) {
    if (!analysed_) factor_.analyzePattern(matrix);
    analysed_ = true;
    factor_.factorize(matrix);
    if (factor_.info() != Eigen::Success || factor_.vectorD().minCoeff() <= 0) return false;
    x = factor_.solve(b);
    return true;
}

MultigridCycle::MultigridCycle(Parallel& parallel, ImplicitSystem& system, std::span<const Vec4> positions)
    : parallel_(parallel),
      multigrid_(parallel, system, positions),
      r_(positions.size()),
      z_(positions.size()) {
    multigrid_.set_pins(positions);
    rebuild();
}

// The residual is scaled to norm 1, the middle of the range of single precision.
void MultigridCycle::apply(const Eigen::VectorXd& r, Eigen::VectorXd& z) {
    const double scale = r.norm();
    z.setZero(r.size());
    if (scale == 0) return;
    for (std::size_t i = 0; i < r_.size(); ++i) {
        const Eigen::Vector3d r_i = r.segment<3>(3 * static_cast<Eigen::Index>(i)) / scale;
        r_[i] = to_vec4(r_i.cast<float>(), 0);
    }
    multigrid_.cycle(parallel_, std::as_const(r_).span(), z_.span());
    for (std::size_t i = 0; i < z_.size(); ++i)
        z.segment<3>(3 * static_cast<Eigen::Index>(i)) = scale * xyz(z_[i]).cast<double>();
}

}  // namespace weft::study
