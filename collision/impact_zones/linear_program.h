#pragma once
// A small linear programme, by the simplex method on a dense table (G. Dantzig, 1951; with the rule of
// R. Bland, 1977, which prevents cycling).

#include <cstddef>
#include <span>
#include <vector>

namespace weft {

/// Minimises cost . x with A x >= b and x >= 0. Only the constructor allocates.
class LinearProgram {
  public:
    /// Allocates the table for up to `most` unknowns, and as many inequalities.
    explicit LinearProgram(std::size_t most = 0);
    [[nodiscard]] std::size_t most() const noexcept { return most_; }

    /// `a` by rows: b.size() rows of cost.size(). Returns whether there is a minimum; if not, x is unchanged.
    /// Preconditions: neither number is above most(); x.size() == cost.size().
    bool minimise(std::span<const double> cost, std::span<const double> a, std::span<const double> b,
                  std::span<double> x);

    [[nodiscard]] std::size_t bytes() const noexcept {
        return table_.capacity() * sizeof(double) + basis_.capacity() * sizeof(std::size_t);
    }

  private:
    [[nodiscard]] double& at(std::size_t row, std::size_t column) { return table_[row * width_ + column]; }
    void pivot(std::size_t row, std::size_t column);
    bool descend(std::size_t columns);

    std::size_t most_, rows_ = 0, width_ = 0;
    std::vector<double> table_;  // rows_ equations, the reduced costs, each with its right-hand side last
    std::vector<std::size_t> basis_;  // by row: its basic unknown
};

}  // namespace weft
