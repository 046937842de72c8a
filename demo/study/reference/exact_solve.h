#pragma once
// Sparse symmetric systems of 3 x 3 blocks, and their solution as exact as double precision allows.

#include <array>
#include <cstdint>
#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <functional>
#include <span>
#include <vector>

#include "cloth/solver/levels/multigrid.h"

namespace weft::study {

/// Two particles that act on each other, the smaller first.
using ParticlePair = std::array<std::uint32_t, 2>;

/// A matrix that has a row of blocks for each particle. Its pattern is made once; then only values change.
class BlockMatrix {
  public:
    using Sparse = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

    /// No pair may occur twice.
    BlockMatrix(std::uint32_t particles, std::span<const ParticlePair> pairs);

    void set_zero();
    /// Adds a symmetric block to the diagonal.
    void add_diagonal(std::uint32_t particle, const Eigen::Matrix3d& block);
    /// Adds a symmetric block off the diagonal, at (i, j) and (j, i) of the pair.
    void add_pair(std::size_t pair, const Eigen::Matrix3d& block);

    /// The lower triangle, the diagonal included.
    [[nodiscard]] const Sparse& lower() const { return lower_; }

  private:
    Sparse lower_;
    std::vector<std::array<int, 3>> pair_values_;  // where the block's three columns begin among the values
};

/// z = an approximation of W^-1 r.
using Preconditioner = std::function<void(const Eigen::VectorXd& r, Eigen::VectorXd& z)>;

/// Solves systems of up to `direct_up_to` particles by a sparse factorisation L D L^T, whose pattern is
/// analysed once. That takes minutes for larger ones, which are left to preconditioned conjugate gradients.
class ExactSolve {
  public:
    static constexpr std::uint32_t usual_limit = 400;

    explicit ExactSolve(std::uint32_t particles, std::uint32_t direct_up_to = usual_limit)
        : is_direct_(particles <= direct_up_to) {}

    [[nodiscard]] bool is_direct() const { return is_direct_; }
    /// Solves matrix x = b; conjugate gradients stop at |b - matrix x| <= tolerance |b|. False if the matrix
    /// is found not to be positive definite.
    bool solve(const BlockMatrix& matrix, const Eigen::VectorXd& b, double tolerance,
               const Preconditioner& precondition, Eigen::VectorXd& x);

  private:
    using Sparse = BlockMatrix::Sparse;
    bool factorise(const Sparse& matrix, const Eigen::VectorXd& b, Eigen::VectorXd& x);

    bool is_direct_, analysed_ = false;
    Eigen::SimplicialLDLT<Sparse, Eigen::Lower> factor_;
};

/// The library's multigrid cycle on vectors in double precision. The cycle's own single precision limits the
/// gain of one cycle, not the accuracy of the iteration around it.
class MultigridCycle {
  public:
    /// Precondition: `system` is linearised. It must outlive the cycle.
    MultigridCycle(Parallel& parallel, ImplicitSystem& system, std::span<const Vec4> positions);

    /// Call this whenever the system has been linearised anew.
    void rebuild() { multigrid_.build(parallel_); }
    void apply(const Eigen::VectorXd& r, Eigen::VectorXd& z);

  private:
    Parallel& parallel_;
    Multigrid multigrid_;
    AlignedBuffer<Vec4> r_, z_;
};

}  // namespace weft::study
