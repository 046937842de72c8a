#pragma once
// What a loop over a grid's rows has at hand of other rows.
//
// A vector is a row of four floats a particle, so that any neighbour is one load; turning 16 neighbours into
// lanes takes seven shuffles. In a grid the neighbours of 16 rows are 16 rows, one after the other: each row
// is turned once, when the loop comes within reach of it, and lies in a ring, x, y and z apart, until the
// loop has passed.
//
// And what two neighbours exchange is worked out once, with the first of them; it lies in another ring, one
// for each diagonal, until the loop comes to the second. A loop that begins in the midst of a grid works out
// what the rows just before it give, a halo: so nothing depends on how rows are cut into tiles.

#include <algorithm>
#include <bit>
#include <cstdint>

#include "cloth/system/grid/diagonals.h"
#include "engine/aligned_buffer.h"
#include "engine/parallel_blocks.h"

namespace weft {

/// One loop's, and how far it has come.
struct GridWindow {
    static constexpr std::uint32_t nowhere = ~0u;

    float* values = nullptr;
    std::uint32_t at = nowhere;  ///< the row at which the loop must go on, or it begins anew
};

/// Memory for the windows of loops over a grid. Empty for what is no grid.
class GridWindows {
  public:
    static constexpr std::uint32_t vectors = 2;  ///< a loop looks ahead on, at most

    GridWindows() = default;
    /// `exchanged`: floats, at most, between two neighbours.
    GridWindows(const Diagonals& diagonals, std::uint32_t exchanged);

    /// How much earlier than needed rows are read: a load that overlaps what has just been stored would wait
    /// until that has left the processor.
    static constexpr std::uint32_t early = 2 * Stencil::lanes;
    /// Of neighbours so near, what is given in a group is taken in it and in the next.
    static constexpr bool is_near(std::uint32_t difference) { return difference < Stencil::lanes; }
    /// Rows in the ring of those ahead, and in a diagonal's, which is a power of two: there row i lies at
    /// place i & (size - 1). Behind a ring lie its first 16 rows again.
    static constexpr std::uint32_t ring_ahead(std::uint32_t reach) { return reach + early + Stencil::lanes; }
    static constexpr std::uint32_t ring_of(std::uint32_t difference) {
        return std::bit_ceil(is_near(difference) ? 4 * Stencil::lanes : Stencil::whole_groups(difference));
    }

    [[nodiscard]] bool empty() const noexcept { return values_.size() == 0; }
    /// Precondition: k < count().
    [[nodiscard]] GridWindow window(std::uint32_t k) {
        return {.values = values_.data() + std::size_t{k} * floats_};
    }
    [[nodiscard]] std::uint32_t count() const noexcept {
        return empty() ? 0 : static_cast<std::uint32_t>(values_.size() / floats_);
    }
    [[nodiscard]] std::size_t bytes() const noexcept { return values_.bytes(); }

    /// Into how many tiles of whole blocks a loop is cut, each with a window. Precondition: not empty.
    [[nodiscard]] std::uint32_t tiles(std::uint32_t rows, int width) const;

  private:
    std::uint32_t floats_ = 0;  // of a window
    AlignedBuffer<float> values_;
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

/// body(block, window) for the blocks of [0, rows); in a grid those of a tile one after the other, else
/// window is null.
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
