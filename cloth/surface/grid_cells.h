#pragma once
// The triangles of a grid, cell by cell: a cell has four particles and is cut along one of its two diagonals.
// Normals and air forces of grids are computed by cells, since the particles of neighbouring cells follow one
// another in memory. A cell is computed once, when the loop comes to its first corner; its other corners read
// their shares from the window (see GridWindows).

#include <cstdint>

#include "cloth/equation/grid/grid_windows.h"
#include "cloth/mesh/cook.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/memory/shared_buffer.h"

namespace weft {

struct GridCells {
    GridCells() = default;
    /// Empty unless the model is a grid, each cell of which has two triangles wound as make_sheet's are.
    /// Empty also for a grid of fewer than least_columns columns: there a cell's far corners would be in the
    /// group of 16 that is just being computed.
    explicit GridCells(const ClothModel& model);

    static constexpr std::uint32_t least_columns = Stencil::lanes;
    static constexpr std::uint32_t most_shared = 4;  ///< floats that a cell shares with each corner, at most

    [[nodiscard]] bool empty() const noexcept { return columns == 0; }
    [[nodiscard]] std::size_t bytes() const noexcept { return cuts.bytes() + window_values.bytes(); }

    std::uint32_t columns = 0;
    /// A single diagonal: from a cell's first corner, near left, to its last, far right.
    Diagonals diagonals;
    /// The cut of each cell, by its first corner: 1 from there to the far right, -1 from the near right to
    /// the far left. 0: the particle is no cell's first corner.
    SharedBuffer<std::int8_t> cuts;
    AlignedBuffer<float> window_values;

    /// Windows for one loop by cells. The next call reuses their memory.
    [[nodiscard]] GridWindows& windows() {
        Scratch scratch(reinterpret_cast<std::byte*>(window_values.data()));
        windows_.lay_out(scratch);
        return windows_;
    }

  private:
    GridWindows windows_;
};

}  // namespace weft
