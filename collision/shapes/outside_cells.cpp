#include "collision/shapes/outside_cells.h"

#include <algorithm>
#include <cmath>

namespace weft {

void OutsideCells::reserve() {
    cells_.reserve(std::size_t{most} * most * most);
    open_.reserve(std::size_t{most} * most * most);
}

std::uint32_t OutsideCells::cell_at(int axis, float place) const {
    const float at = (place - origin_[axis]) * per_cell_;
    const auto last = static_cast<float>(counts_[static_cast<std::size_t>(axis)] - 1);
    return static_cast<std::uint32_t>(std::clamp(at, 0.0f, last));
}

void OutsideCells::find(const TriangleTree& tree) {
    const Eigen::AlignedBox3f box = tree.box();
    const float cell = std::max(box.sizes().maxCoeff() / static_cast<float>(most - 3), 1e-9f);
    per_cell_ = 1 / cell;
    origin_ = box.min() - Vector3::Constant(1.5f * cell);
    for (int axis = 0; axis < 3; ++axis)
        counts_[static_cast<std::size_t>(axis)] =
            std::min(static_cast<std::uint32_t>(box.sizes()[axis] * per_cell_) + 4, most);
    cells_.assign(std::size_t{counts_[0]} * counts_[1] * counts_[2], Cell::unknown);
    for (const TriangleTree::Node& node : tree.nodes())
        if (node.count > 0) touch(node);
    flood();
}

void OutsideCells::touch(const TriangleTree::Node& leaf) {
    std::array<std::uint32_t, 3> first{}, last{};
    for (int axis = 0; axis < 3; ++axis) {
        // A margin of a thousandth of a cell, so that rounding leaves out no cell.
        const float margin = 1e-3f / per_cell_;
        first[static_cast<std::size_t>(axis)] = cell_at(axis, to_vector(leaf.lower)[axis] - margin);
        last[static_cast<std::size_t>(axis)] = cell_at(axis, to_vector(leaf.upper)[axis] + margin);
    }
    for (std::uint32_t z = first[2]; z <= last[2]; ++z)
        for (std::uint32_t y = first[1]; y <= last[1]; ++y) {
            const std::size_t row = std::size_t{counts_[0]} * (y + std::size_t{counts_[1]} * z);
            std::fill(&cells_[row + first[0]], &cells_[row + last[0]] + 1, Cell::touched);
        }
}

void OutsideCells::visit(std::uint32_t cell) {
    if (cells_[cell] != Cell::unknown) return;
    cells_[cell] = Cell::outside;
    open_.push_back(cell);
}

/// The flood starts at the first corner: the border is one cell wide and no leaf touches it.
void OutsideCells::flood() {
    const std::uint32_t row = counts_[0], layer = row * counts_[1];
    open_.clear();
    visit(0);
    while (!open_.empty()) {
        const std::uint32_t cell = open_.back();
        open_.pop_back();
        const std::uint32_t x = cell % row, y = cell / row % counts_[1], z = cell / layer;
        if (x > 0) visit(cell - 1);
        if (x + 1 < row) visit(cell + 1);
        if (y > 0) visit(cell - row);
        if (y + 1 < counts_[1]) visit(cell + row);
        if (z > 0) visit(cell - layer);
        if (z + 1 < counts_[2]) visit(cell + layer);
    }
}

bool OutsideCells::are_outside(const Vector3& q) const {
    const std::uint32_t x = cell_at(0, q.x()), y = cell_at(1, q.y()), z = cell_at(2, q.z());
    return cells_[x + std::size_t{counts_[0]} * (y + std::size_t{counts_[1]} * z)] == Cell::outside;
}

}  // namespace weft
