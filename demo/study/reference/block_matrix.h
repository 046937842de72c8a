#pragma once
// A sparse symmetric matrix of 3x3 blocks, one row of blocks per particle, in double precision. Its pattern
// is made once; then only values change.

#include <array>
#include <cstdint>
#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <span>
#include <vector>

namespace weft::study {

/// Two particles that act on each other, the smaller first.
using ParticlePair = std::array<std::uint32_t, 2>;

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

}  // namespace weft::study
