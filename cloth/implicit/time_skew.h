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

#include "cloth/implicit/grid_windows.h"
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

/// Rows a thread that its cache holds anyway, for which one sweep after another is faster.
inline constexpr std::uint32_t cached_rows = 8192;

/// How [0, rows) is cut: a tile of whole groups for each thread.
struct SkewedTiles {
    std::uint32_t rows = 0;
    std::uint32_t reach = 0;   ///< rows; whole groups
    std::uint32_t sweeps = 1;  ///< in one pass over the tiles
    std::uint32_t tiles = 0;   ///< 0: too few rows for any

    /// As many of `sweeps` in one pass as leave gaps of at most a quarter of the tiles.
    SkewedTiles(std::uint32_t all_rows, std::uint32_t reach_in_rows, std::uint32_t wanted_sweeps,
                std::uint32_t threads)
        : rows(all_rows), reach(Stencil::whole_groups(reach_in_rows)), sweeps(wanted_sweeps) {
        const std::uint32_t tile = rows / threads, shortest = std::max(4 * reach, block_size);
        while (sweeps > 1 && tile < sweeps * shortest) --sweeps;
        if (sweeps > 1) tiles = threads;
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

/// Rows that one sweep goes on for before the next one follows: many, since with each of them a grid's window
/// comes into the nearest cache anew; few enough for all sweeps' rows to stay in the next one.
inline constexpr std::uint32_t sweep_step = 4 * block_size;

/// body(k, rows) for the sweeps k < tiles.sweeps of one tile.
template <class Body>
void sweep_tile(const SkewedTiles& tiles, std::uint32_t tile, const Body& body) {
    const std::uint32_t last_lag = (tiles.sweeps - 1) * tiles.reach;
    for (std::uint32_t at = tiles.first(tile, 0); at < tiles.last(tile, 0) + last_lag; at += sweep_step) {
        for (std::uint32_t k = 0, lag = 0; k < tiles.sweeps; ++k, lag += tiles.reach) {
            const std::uint32_t begin = std::max(tiles.first(tile, k), at - std::min(at, lag));
            const std::uint32_t end = std::min(tiles.last(tile, k), std::max(at + sweep_step, lag) - lag);
            if (begin < end) body(k, BlockRange{begin, end, begin / block_size});
        }
    }
}

/// body(rows, window) for all rows that sweep k of the tiles left out. There are few gaps, so each is shared
/// out too: among as many parts as there are windows for, in a grid, where each part has a halo.
template <class Body>
void fill_gaps(Parallel& parallel, const SkewedTiles& tiles, std::uint32_t k, GridWindows& windows,
               const Body& body) {
    const std::uint32_t gaps = tiles.tiles - 1, gap = 2 * k * tiles.reach;
    if (gaps == 0) return;
    const auto threads = static_cast<std::uint32_t>(parallel.width());
    const std::uint32_t parts =
        windows.empty() ? block_count(gap) : std::clamp(windows.count() / gaps, 1u, std::min(threads, 2 * k));
    const std::uint32_t size = Stencil::whole_groups((gap + parts - 1) / parts);
    parallel.blocks(gaps * parts, [&](std::uint32_t part) {
        const std::uint32_t edge = tiles.edge(part / parts + 1), end = edge + k * tiles.reach;
        const std::uint32_t begin = edge - k * tiles.reach + part % parts * size;
        GridWindow window;
        if (!windows.empty()) window = windows.window(part);
        if (begin < end)
            body(BlockRange{begin, std::min(begin + size, end), part}, windows.empty() ? nullptr : &window);
    });
}

/// The windows of the sweeps of a tile.
class TileWindows {
  public:
    TileWindows(GridWindows& windows, std::uint32_t tile, std::uint32_t sweeps) {
        if (windows.empty()) return;
        for (std::uint32_t k = 0; k < sweeps; ++k) windows_[k] = windows.window(tile * sweeps + k);
    }
    /// Null if there are none.
    GridWindow* of_sweep(std::uint32_t k) { return windows_[k].values == nullptr ? nullptr : &windows_[k]; }

  private:
    std::array<GridWindow, most_skewed_sweeps> windows_;
};

/// body(k, rows, window) for sweeps k < `sweeps` over [0, rows) in as few passes as pay: sweep k reads, of
/// what sweep k - 1 wrote, rows no further than `reach` from its own, and may write over what sweep k - 2
/// wrote in its own. In a grid there is a `window`, else it is null. Precondition: sweeps <=
/// most_skewed_sweeps.
template <class Body>
void skewed_sweeps(Parallel& parallel, std::uint32_t rows, std::uint32_t reach, std::uint32_t sweeps,
                   GridWindows& windows, const Body& body, std::uint32_t cached = cached_rows) {
    const auto threads = static_cast<std::uint32_t>(parallel.width());
    const SkewedTiles tiles(rows, reach + (windows.empty() ? 0 : GridWindows::early), sweeps, threads);
    if (tiles.tiles == 0 || rows <= cached * threads) {
        for (std::uint32_t k = 0; k < sweeps; ++k)
            blocks_in_tiles(parallel, rows, windows,
                            [&](const BlockRange& range, GridWindow* window) { body(k, range, window); });
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
            fill_gaps(parallel, pass, k, windows,
                      [&](const BlockRange& range, GridWindow* window) { body(done + k, range, window); });
    }
}

}  // namespace weft
