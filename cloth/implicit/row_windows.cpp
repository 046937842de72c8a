#include "cloth/implicit/row_windows.h"

#include <algorithm>

#include "cloth/implicit/time_skew.h"

namespace weft {

namespace {

/// Tiles shorter than this spend too much on what their windows begin with.
std::uint32_t shortest_tile(std::uint32_t reach) {
    return std::max(4 * reach, block_size);
}

}  // namespace

RowWindows::RowWindows(const Stencil& stencil) {
    const auto listed = static_cast<std::size_t>(std::ranges::count(stencil.runs.span(), Stencil::no_run));
    if (stencil.slots() == 0 || listed > stencil.slots() / 8) return;
    reach_ = SkewedTiles::whole_groups(stencil.reach);  // as far as one sweep runs behind another
    // Behind, at, and ahead of a group of 16, one of which is being filled.
    rows_ = 2 * reach_ + 2 * Stencil::lanes;
    values_ = AlignedBuffer<float>(floats() * 2 * std::max(1u, stencil.nodes / shortest_tile(reach_)));
}

RowWindow RowWindows::window(std::uint32_t k) {
    return {.values = values_.data() + k * floats(), .reach = reach_, .rows = rows_};
}

std::uint32_t RowWindows::tiles(std::uint32_t rows, int width) const {
    if (empty()) return 0;
    const auto threads = static_cast<std::uint32_t>(width);
    const std::uint32_t most = std::max(1u, rows / shortest_tile(reach_));
    const std::uint32_t tiles = std::min({4 * threads, most, block_count(rows)});
    return tiles - tiles % threads;
}

}  // namespace weft
