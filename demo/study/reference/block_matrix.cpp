#include "demo/study/reference/block_matrix.h"

#include <algorithm>

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

}  // namespace weft::study
