#include "cloth/equation/grid/grid_windows.h"

namespace weft {

namespace {

/// Rows of the shortest tile: its halo, one reach, is at most a quarter of it.
std::uint32_t shortest_tile(std::uint32_t reach) {
    return std::max(4 * reach, block_size);
}

}  // namespace

GridWindows::GridWindows(const Diagonals& diagonals, std::uint32_t exchanged) {
    if (diagonals.empty()) return;
    const std::uint32_t reach = diagonals.reach();
    floats_ = 3 * vectors * (ring_ahead(reach) + Stencil::lanes);
    for (std::uint32_t d = 0; d < diagonals.count; ++d)
        floats_ += exchanged * (ring_of(diagonals.differences[d]) + Stencil::lanes);
    count_ = std::max(1u, diagonals.nodes / shortest_tile(reach));
}

std::uint32_t GridWindows::tiles(std::uint32_t rows, int width) const {
    const auto threads = static_cast<std::uint32_t>(width);
    const std::uint32_t wanted = threads == 1 ? 1 : 2 * threads;
    const std::uint32_t tiles = std::min({wanted, count(), block_count(rows)});
    return tiles < threads ? tiles : tiles - tiles % threads;  // as many for each thread
}

}  // namespace weft
