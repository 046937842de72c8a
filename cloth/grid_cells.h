#pragma once
// The triangles of a grid, cell by cell: each cell of four particles is two triangles, cut along one of its
// diagonals or the other. What normals and air forces are computed by there: neighbours lie in windows, and a
// cell is worked out once, with its first corner; the others take theirs from the window.

#include <cstdint>

#include "cloth/cook.h"
#include "cloth/implicit/grid_windows.h"
#include "engine/aligned_buffer.h"

namespace weft {

struct GridCells {
    GridCells() = default;
    /// Empty unless every cell of a grid has two triangles, both wound as make_sheet's are.
    explicit GridCells(const CookedCloth& model);

    [[nodiscard]] bool empty() const noexcept { return corners.empty(); }
    [[nodiscard]] std::size_t bytes() const noexcept { return cuts.bytes() + windows.bytes(); }

    /// From a cell's first corner, which is near and left, to the others: near right, far left, far right.
    Diagonals corners;
    /// Of the cell that each particle is first of: 1 from there to the far right, -1 from near right to far
    /// left, 0: it is first of none.
    AlignedBuffer<std::int8_t> cuts;
    GridWindows windows;
};

}  // namespace weft
