#pragma once
// What loops over rows read of the neighbours, x, y and z apart.
//
// A vector is a row of four floats a particle, so that any neighbour is one load; turning 16 neighbours into
// lanes takes seven shuffles. In a grid the neighbours of 16 rows mostly are 16 rows, one after the other:
// there each row is turned once, when the loop comes within reach of it, into a window that goes along with
// the loop, and neighbours are three loads. Lanes get the same floats either way.

#include <cstdint>

#include "cloth/implicit/stencil.h"
#include "engine/aligned_buffer.h"
#include "engine/parallel_blocks.h"

namespace weft {

/// One vector's, and how far it has come.
struct RowWindow {
    static constexpr std::uint32_t nowhere = ~0u;

    float* values = nullptr;     ///< three times `rows`, and the first 16 of them again
    std::uint32_t reach = 0;     ///< of the stencil; whole groups
    std::uint32_t rows = 0;      ///< in a ring, which is entered at `origin`
    std::uint32_t at = nowhere;  ///< the row at which the loop must go on, or all is read anew
    std::uint32_t origin = 0, end = 0;
};

/// Memory for the windows of loops over one stencil's rows. Empty where it is no grid, mostly.
class RowWindows {
  public:
    RowWindows() = default;
    explicit RowWindows(const Stencil& stencil);

    [[nodiscard]] bool empty() const noexcept { return values_.size() == 0; }
    /// Precondition: k < count().
    [[nodiscard]] RowWindow window(std::uint32_t k);
    [[nodiscard]] std::uint32_t count() const noexcept {
        return empty() ? 0 : static_cast<std::uint32_t>(values_.size() / floats());
    }
    [[nodiscard]] std::size_t bytes() const noexcept { return values_.bytes(); }

    /// Into how many tiles of whole blocks a loop with two windows a tile is cut, as much for each thread; 0:
    /// they would be too small for windows.
    [[nodiscard]] std::uint32_t tiles(std::uint32_t rows, int width) const;

  private:
    [[nodiscard]] std::size_t floats() const noexcept { return std::size_t{3} * (rows_ + Stencil::lanes); }

    std::uint32_t reach_ = 0, rows_ = 0;
    AlignedBuffer<float> values_;
};

struct WindowPair {
    RowWindow first, second;
};
/// For a loop over one vector's neighbours.
inline RowWindow* first_of(WindowPair* windows) {
    return windows == nullptr ? nullptr : &windows->first;
}

/// body(block, windows) for the blocks of [0, rows), those of a tile one after the other; windows is null
/// where there are none.
template <class Body>
void blocks_in_tiles(Parallel& parallel, std::uint32_t rows, RowWindows& windows, const Body& body) {
    const std::uint32_t tiles = windows.tiles(rows, parallel.width());
    if (tiles == 0) {
        parallel.ranges(rows,
                        [&](const BlockRange& range) { body(range, static_cast<WindowPair*>(nullptr)); });
        return;
    }
    const std::uint32_t blocks = block_count(rows);
    parallel.blocks(tiles, [&](std::uint32_t tile) {
        WindowPair pair{windows.window(2 * tile), windows.window(2 * tile + 1)};
        for (std::uint32_t block = blocks * tile / tiles; block < blocks * (tile + 1) / tiles; ++block)
            body(BlockRange{block * block_size, std::min(rows, (block + 1) * block_size), block}, &pair);
    });
}

}  // namespace weft
