#pragma once
// Interpolation from a coarse level to a finer one (prolongation).

#include <cstdint>
#include <vector>

#include "engine/memory/shared_buffer.h"

namespace weft {

/// x_fine = P x_coarse, at most `width` weights a row. Rows sum to 1, so that rigid translations are kept; a
/// node without springs has weights 0.
struct Interpolation {
    static constexpr std::uint32_t width = 3;

    Interpolation() = default;
    /// Sets all weights to 0.
    Interpolation(std::uint32_t fine_count, std::uint32_t coarse_count);

    std::uint32_t fine = 0, coarse = 0;
    SharedBuffer<std::uint32_t> nodes;  ///< [width * i + k], for whole groups of fine nodes i
    SharedBuffer<float> weights;
    std::vector<std::uint32_t> kept;  ///< the fine node at each coarse node, ascending

    /// P^T by rows, ascending, for gathering.
    SharedBuffer<std::uint32_t> offsets, entries;  ///< entries: places width * i + k in `weights`

    [[nodiscard]] std::size_t bytes() const noexcept;
};

}  // namespace weft
