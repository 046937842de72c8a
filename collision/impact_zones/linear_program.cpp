#include "collision/impact_zones/linear_program.h"

#include <algorithm>
#include <cmath>

namespace weft {

namespace {

constexpr double tiny = 1e-11;  // a smaller cost or pivot counts as none: the table is scaled to about 1

double largest(std::span<const double> values) {
    double most = 0;
    for (const double value : values) most = std::max(most, std::abs(value));
    return most > 0 ? most : 1;
}

}  // namespace

LinearProgram::LinearProgram(std::size_t most)
    : most_(most), table_((most + 1) * (3 * most + 1)), basis_(most) {}

void LinearProgram::pivot(std::size_t row, std::size_t column) {
    const double scale = 1 / at(row, column);
    for (std::size_t k = 0; k < width_; ++k) at(row, k) *= scale;
    for (std::size_t r = 0; r <= rows_; ++r) {
        const double factor = at(r, column);
        if (r == row || factor == 0) continue;
        for (std::size_t k = 0; k < width_; ++k) at(r, k) -= factor * at(row, k);
        at(r, column) = 0;
    }
    basis_[row] = column;
}

/// Pivots from vertex to vertex, with unknowns from the first so many columns. Returns false if there is no
/// minimum, or none within the limit of steps.
bool LinearProgram::descend(std::size_t columns) {
    const std::size_t most_steps = 4 * (rows_ + columns);
    for (std::size_t step = 0; step < most_steps; ++step) {
        std::size_t entering = 0;
        while (entering < columns && at(rows_, entering) >= -tiny) ++entering;
        if (entering == columns) return true;
        std::size_t leaving = rows_;
        double least = 0;
        for (std::size_t r = 0; r < rows_; ++r) {
            if (at(r, entering) <= tiny) continue;
            const double ratio = at(r, width_ - 1) / at(r, entering);
            if (leaving == rows_ || ratio < least || (ratio == least && basis_[r] < basis_[leaving])) {
                leaving = r;
                least = ratio;
            }
        }
        if (leaving == rows_) return false;
        pivot(leaving, entering);
    }
    return false;
}

// Columns: the unknowns, a surplus for each row, and an artificial unknown for each row that x = 0 violates.
// The first phase brings the sum of the artificial ones to 0, the second minimises the cost.
bool LinearProgram::minimise(std::span<const double> cost, std::span<const double> a,
                             std::span<const double> b, std::span<double> x) {
    const std::size_t n = cost.size();
    rows_ = b.size();
    width_ = n + 2 * rows_ + 1;
    const double of_a = largest(a), of_b = largest(b), of_cost = largest(cost);
    std::fill_n(table_.begin(), (rows_ + 1) * width_, 0.0);
    for (std::size_t r = 0; r < rows_; ++r) {
        const bool is_broken = b[r] > 0;
        const double sign = is_broken ? 1 : -1;
        for (std::size_t k = 0; k < n; ++k) at(r, k) = sign * a[r * n + k] / of_a;
        at(r, n + r) = -sign;
        at(r, width_ - 1) = sign * b[r] / of_b;
        basis_[r] = is_broken ? n + rows_ + r : n + r;
        if (!is_broken) continue;
        at(r, n + rows_ + r) = 1;
        for (std::size_t k = 0; k < width_; ++k) at(rows_, k) -= at(r, k);
        at(rows_, n + rows_ + r) = 0;
    }
    if (!descend(n + rows_) || at(rows_, width_ - 1) < -1e-9) return false;
    for (std::size_t r = 0; r < rows_; ++r) {
        if (basis_[r] < n + rows_) continue;  // an artificial unknown that is 0 leaves if another can enter
        std::size_t k = 0;
        while (k < n + rows_ && std::abs(at(r, k)) <= tiny) ++k;
        if (k < n + rows_) pivot(r, k);
    }
    for (std::size_t k = 0; k < width_; ++k) at(rows_, k) = k < n ? cost[k] / of_cost : 0;
    for (std::size_t r = 0; r < rows_; ++r) {
        const double factor = at(rows_, basis_[r]);
        for (std::size_t k = 0; k < width_; ++k) at(rows_, k) -= factor * at(r, k);
    }
    if (!descend(n + rows_)) return false;
    std::ranges::fill(x, 0.0);
    for (std::size_t r = 0; r < rows_; ++r)
        if (basis_[r] < n) x[basis_[r]] = at(r, width_ - 1) * of_b / of_a;
    return true;
}

}  // namespace weft
