#pragma once
// The triangles of a grid, cell by cell: each cell of four particles is two triangles, cut along one of its
// diagonals or the other. What normals and air forces are computed by there: neighbours lie in windows, and a
// cell is worked out once, with its first corner; the far ones take theirs from the window.

#include <cstdint>

#include "cloth/mesh/cook.h"
#include "cloth/system/grid/grid_windows.h"
#include "engine/aligned_buffer.h"

namespace weft {

struct GridCells {
    GridCells() = default;
    /// Empty unless every cell of a grid has two triangles, both wound as make_sheet's are; and where a grid
    /// is so narrow that what a part of a group has for the far corners goes to the same part.
    explicit GridCells(const CookedCloth& model);

    static constexpr std::uint32_t least_columns = Stencil::lanes;
    static constexpr std::uint32_t most_shared = 4;  ///< floats that a cell has for each corner

    [[nodiscard]] bool empty() const noexcept { return columns == 0; }
    [[nodiscard]] std::size_t bytes() const noexcept { return cuts.bytes() + windows.bytes(); }

    std::uint32_t columns = 0;
    /// From a cell's first corner, which is near and left, to the last, which is far and right.
    Diagonals diagonals;
    /// Of the cell that each particle is first of: 1 from there to the far right, -1 from near right to far
    /// left, 0: it is first of none.
    AlignedBuffer<std::int8_t> cuts;
    GridWindows windows;
};

}  // namespace weft
