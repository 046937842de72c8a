#pragma once
// Sparse systems solved as exactly as double precision allows.

#include <cstdint>
#include <Eigen/SparseCholesky>
#include <functional>

#include "cloth/solver/levels/multigrid.h"
#include "demo/study/reference/block_matrix.h"

namespace weft::study {

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
