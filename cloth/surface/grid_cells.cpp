#include "cloth/surface/grid_cells.h"

#include <algorithm>
#include <array>
#include <vector>

namespace weft {

namespace {

/// The same triangle, from its least corner on.
Triangle from_least(const Triangle& t) {
    const auto least = static_cast<std::size_t>(std::ranges::min_element(t) - t.begin());
    return {t[least], t[(least + 1) % 3], t[(least + 2) % 3]};
}

/// For each cell, by its first corner, a bit for each triangle that it has: 1 and 2 of one cut, 4 and 8 of
/// the other. Empty if a triangle is no cell's.
std::vector<std::uint8_t> triangles_of_cells(const ClothModel& model) {
    const std::uint32_t columns = model.columns;
    std::vector<std::uint8_t> found(model.particle_count);
    for (const Triangle& triangle : model.triangles) {
        const auto [a, b, c] = from_least(triangle);
        const std::array<std::uint32_t, 2> others{b - a, c - a};
        const bool beside = others == std::array{columns - 1, columns};  // its least corner is near right
        const std::uint32_t first = beside ? a - 1 : a;
        std::uint8_t kind = beside ? 8 : 0;
        if (others == std::array{columns, columns + 1}) kind = 1;
        if (others == std::array{columns + 1, 1u}) kind = 2;
        if (others == std::array{columns, 1u}) kind = 4;
        if (kind == 0 || first >= found.size() || first % columns + 1 == columns) return {};
        found[first] |= kind;
    }
    return found;
}

}  // namespace

GridCells::GridCells(const ClothModel& model) {
    if (model.rows < 2 || model.columns < least_columns) return;
    if (model.rows * model.columns != model.particle_count) return;
    if (model.triangles.size() != std::size_t{2} * (model.rows - 1) * (model.columns - 1)) return;
    const std::vector<std::uint8_t> found = triangles_of_cells(model);
    if (found.empty()) return;
    AlignedBuffer<std::int8_t> cut(model.particle_count);
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        if (found[i] != 0 && found[i] != 3 && found[i] != 12) return;
        cut[i] = static_cast<std::int8_t>((found[i] == 3) - (found[i] == 12));
    }
    diagonals.nodes = model.particle_count;
    diagonals.count = 1;
    diagonals.differences = {model.columns + 1};
    columns = model.columns;
    cuts = std::move(cut);
    windows_ = GridWindows(diagonals, most_shared);
    window_values = AlignedBuffer<float>(windows_.floats());
}

}  // namespace weft
