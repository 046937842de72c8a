#pragma once
// A window: the values of other rows that a loop over a grid's rows keeps.
//
// In memory a row is the four floats of one particle, and turning 16 rows into lanes takes shuffles. In a
// grid the neighbours of 16 consecutive rows are again consecutive. So each row is turned once, when the loop
// comes within reach of it, and kept in a ring buffer, x, y and z apart, until the loop has passed it.
//
// Values that two neighbours exchange are computed once, at the first of them, and kept in a ring buffer of
// their diagonal until the loop comes to the second. A loop that begins inside the grid first computes its
// halo, the values that the rows before its own give. So no result depends on how rows are cut into tiles.

#include <algorithm>
#include <bit>
#include <cstdint>

#include "cloth/equation/grid/diagonals.h"
#include "engine/memory/scratch.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

/// The window of one loop, and how far the loop has come.
struct GridWindow {
    static constexpr std::uint32_t nowhere = ~0u;

    float* values = nullptr;
    std::uint32_t at = nowhere;  ///< the row at which the loop can continue; elsewhere it starts anew
};

/// The windows of loops over a grid, in scratch. Empty without a grid.
class GridWindows {
  public:
    static constexpr std::uint32_t vectors = 2;  ///< most vectors whose rows a loop reads ahead

    GridWindows() = default;
    /// `exchanged`: the most floats that one neighbour gives the other.
    GridWindows(const Diagonals& diagonals, std::uint32_t exchanged);
    void lay_out(Scratch& scratch) { scratch.take(values_, floats()); }
    [[nodiscard]] std::size_t floats() const noexcept { return std::size_t{count_} * floats_; }

    /// Rows are read this many rows before their use: a load that overlaps a recent store waits until the
    /// store has reached the cache.
    static constexpr std::uint32_t early = 2 * Stencil::lanes;
    /// Whether the values that a group of 16 gives are taken within that group and the next one.
    static constexpr bool is_near(std::uint32_t difference) { return difference < Stencil::lanes; }
    /// Sizes of the ring of rows read ahead, and of the ring of a diagonal [rows]. The latter is a power of
    /// two, so that row i lies at place i & (size - 1). The first 16 rows of a ring are repeated behind its
    /// end, so that a load of 16 may begin at any place.
    static constexpr std::uint32_t ring_ahead(std::uint32_t reach) { return reach + early + Stencil::lanes; }
    static constexpr std::uint32_t ring_of(std::uint32_t difference) {
        return std::bit_ceil(is_near(difference) ? 4 * Stencil::lanes : Stencil::whole_groups(difference));
    }

    [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
    /// Precondition: k < count().
    [[nodiscard]] GridWindow window(std::uint32_t k) {
        return {.values = values_.data() + std::size_t{k} * floats_};
    }
    [[nodiscard]] std::uint32_t count() const noexcept { return count_; }

    /// Number of tiles of whole blocks that a loop is cut into, each with a window. Precondition: not empty.
    [[nodiscard]] std::uint32_t tiles(std::uint32_t rows, int width) const;

  private:
    std::uint32_t count_ = 0, floats_ = 0;  // windows, and floats of each
    ScratchArray<float> values_;
};

/// body(tile, window) for tiles of [0, rows), each of whole blocks. Precondition: windows are not empty.
template <class Body>
void in_tiles(Parallel& parallel, std::uint32_t rows, GridWindows& windows, const Body& body) {
    const std::uint32_t blocks = block_count(rows), tiles = windows.tiles(rows, parallel.width());
    parallel.blocks(tiles, [&](std::uint32_t tile) {
        const std::uint32_t begin = blocks * tile / tiles * block_size;
        const std::uint32_t end = blocks * (tile + 1) / tiles * block_size;
        body(BlockRange{begin, std::min(rows, end), tile}, windows.window(tile));
    });
}

/// body(block, window) for the blocks of [0, rows). In a grid the blocks of a tile come one after the other;
/// without a grid, window is null.
template <class Body>
void blocks_in_tiles(Parallel& parallel, std::uint32_t rows, GridWindows& windows, const Body& body) {
    if (windows.empty()) {
        parallel.ranges(rows,
                        [&](const BlockRange& range) { body(range, static_cast<GridWindow*>(nullptr)); });
        return;
    }
    in_tiles(parallel, rows, windows, [&](const BlockRange& tile, GridWindow window) {
        for (std::uint32_t begin = tile.begin; begin < tile.end; begin += block_size)
            body(BlockRange{begin, std::min(tile.end, begin + block_size), begin / block_size}, &window);
    });
}

}  // namespace weft
