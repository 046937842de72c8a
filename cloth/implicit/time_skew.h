#pragma once
// Several sweeps over rows in one pass over memory: J. McCalpin, D. Wonnacott, "Time skewing: a value-based
// approach to optimizing for memory locality", 1999.
//
// Within a tile, sweep k runs k times the reach behind sweep 0, where what sweep k - 1 left is still in the
// cache; it also ends that much short of the tile's ends, where it would need rows of other tiles. These gaps
// are filled once all tiles are done. Each row's value comes from the same values as in sweeps one after
// another, so the tiles, which do depend on the number of threads, do not show in any result.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "cloth/implicit/row_windows.h"
#include "cloth/implicit/stencil.h"
#include "engine/parallel_blocks.h"

namespace weft {

/// Sweeps that may be asked for at once.
inline constexpr std::uint32_t most_skewed_sweeps = 5;

/// Of those left, how many to ask for next: the most, or fewer where these come out even.
constexpr std::size_t next_sweeps(std::size_t left) {
    const std::size_t passes = (left + most_skewed_sweeps - 1) / most_skewed_sweeps;
    return (left + passes - 1) / passes;
}

/// How [0, rows) is cut; tiles of whole groups.
struct SkewedTiles {
    std::uint32_t rows = 0;
    std::uint32_t reach = 0;   ///< rows; whole groups
    std::uint32_t sweeps = 1;  ///< in one pass over the tiles
    std::uint32_t tiles = 0;   ///< 0: too few rows for any

    /// So many of `sweeps` in one pass that gaps are at most a quarter of the tiles.
    SkewedTiles(std::uint32_t all_rows, std::uint32_t reach_in_rows, std::uint32_t wanted_sweeps,
                std::uint32_t threads)
        : rows(all_rows), reach(whole_groups(reach_in_rows)) {
        for (sweeps = wanted_sweeps; sweeps > 1; --sweeps) {
            tiles = std::min(2 * threads, rows / std::max(4 * sweeps * reach, block_size));
            tiles -= tiles % threads;  // as much for each of them
            if (tiles > 0) return;
        }
        tiles = 0;
    }

    static constexpr std::uint32_t whole_groups(std::uint32_t n) {
        return (n + Stencil::lanes - 1) / Stencil::lanes * Stencil::lanes;
    }
    [[nodiscard]] std::uint32_t edge(std::uint32_t tile) const {
        return tile == tiles ? rows : rows / tiles / Stencil::lanes * Stencil::lanes * tile;
    }
    /// Where a sweep begins and ends in a tile.
    [[nodiscard]] std::uint32_t first(std::uint32_t tile, std::uint32_t sweep) const {
        return tile == 0 ? 0 : edge(tile) + sweep * reach;
    }
    [[nodiscard]] std::uint32_t last(std::uint32_t tile, std::uint32_t sweep) const {
        return tile + 1 == tiles ? rows : edge(tile + 1) - sweep * reach;
    }
};

/// body(k, rows) for the sweeps k < tiles.sweeps of one tile.
template <class Body>
void sweep_tile(const SkewedTiles& tiles, std::uint32_t tile, const Body& body) {
    const std::uint32_t last_lag = (tiles.sweeps - 1) * tiles.reach;
    for (std::uint32_t at = tiles.first(tile, 0); at < tiles.last(tile, 0) + last_lag; at += block_size) {
        for (std::uint32_t k = 0, lag = 0; k < tiles.sweeps; ++k, lag += tiles.reach) {
            const std::uint32_t begin = std::max(tiles.first(tile, k), at - std::min(at, lag));
            const std::uint32_t end = std::min(tiles.last(tile, k), std::max(at + block_size, lag) - lag);
            if (begin < end) body(k, BlockRange{begin, end, begin / block_size});
        }
    }
}

/// body(rows) for all rows that sweep k of the tiles left out. There are few gaps, so each is shared out too.
template <class Body>
void fill_gaps(Parallel& parallel, const SkewedTiles& tiles, std::uint32_t k, const Body& body) {
    const std::uint32_t blocks = block_count(2 * k * tiles.reach);
    parallel.blocks((tiles.tiles - 1) * blocks, [&](std::uint32_t part) {
        const std::uint32_t edge = tiles.edge(part / blocks + 1);
        const std::uint32_t begin = edge - k * tiles.reach + part % blocks * block_size;
        body(BlockRange{begin, std::min(begin + block_size, edge + k * tiles.reach), part});
    });
}

/// The windows of the sweeps of a tile.
class TileWindows {
  public:
    TileWindows(RowWindows& windows, std::uint32_t tile, std::uint32_t sweeps) {
        if ((tile + 1) * sweeps > windows.count()) return;
        for (std::uint32_t k = 0; k < sweeps; ++k) windows_[k] = windows.window(tile * sweeps + k);
    }
    /// Null if there are none.
    RowWindow* of_sweep(std::uint32_t k) { return windows_[k].values == nullptr ? nullptr : &windows_[k]; }

  private:
    std::array<RowWindow, most_skewed_sweeps> windows_;
};

/// body(k, rows, window) for sweeps k < `sweeps` over [0, rows) in as few passes as pay: sweep k reads, of
/// what sweep k - 1 wrote, rows no further than `reach` from its own, and may write over what sweep k - 2
/// wrote in its own. `window`, on what it reads, may be null. Precondition: sweeps <= most_skewed_sweeps.
template <class Body>
void skewed_sweeps(Parallel& parallel, std::uint32_t rows, std::uint32_t reach, std::uint32_t sweeps,
                   RowWindows& windows, const Body& body) {
    const SkewedTiles tiles(rows, reach, sweeps, static_cast<std::uint32_t>(parallel.width()));
    if (tiles.tiles == 0) {
        for (std::uint32_t k = 0; k < sweeps; ++k)
            blocks_in_tiles(parallel, rows, windows, [&](const BlockRange& range, WindowPair* of_tile) {
                body(k, range, first_of(of_tile));
            });
        return;
    }
    for (std::uint32_t done = 0; done < sweeps; done += tiles.sweeps) {
        SkewedTiles pass = tiles;
        pass.sweeps = std::min(tiles.sweeps, sweeps - done);
        parallel.blocks(pass.tiles, [&](std::uint32_t tile) {
            TileWindows of_tile(windows, tile, pass.sweeps);
            sweep_tile(pass, tile, [&](std::uint32_t k, const BlockRange& range) {
                body(done + k, range, of_tile.of_sweep(k));
            });
        });
        for (std::uint32_t k = 1; k < pass.sweeps; ++k)
            fill_gaps(parallel, pass, k, [&](const BlockRange& range) { body(done + k, range, nullptr); });
    }
}

}  // namespace weft
