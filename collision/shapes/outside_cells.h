#pragma once
// Cells that lie certainly outside a closed mesh, however its vertices have moved.

#include <array>
#include <cstdint>
#include <vector>

#include "collision/shapes/triangle_tree.h"

namespace weft {

/// A grid over the mesh's bounding box. A cell is outside if no leaf of the tree touches it and cells like it
/// connect it to the grid's border.
class OutsideCells {
  public:
    /// Reserves memory. May throw.
    void reserve();
    /// Finds the outside cells. Precondition: reserve().
    void find(const TriangleTree& tree);
    void clear() { cells_.clear(); }
    [[nodiscard]] bool known() const { return !cells_.empty(); }
    [[nodiscard]] bool are_outside(const Vector3& q) const;
    [[nodiscard]] std::size_t bytes() const {
        return cells_.capacity() * sizeof(Cell) + open_.capacity() * sizeof(std::uint32_t);
    }

  private:
    enum class Cell : std::uint8_t { unknown, touched, outside };
    static constexpr std::uint32_t most = 40;  // cells along the longest side, with a border of one

    [[nodiscard]] std::uint32_t cell_at(int axis, float place) const;
    void touch(const TriangleTree::Node& leaf);
    void visit(std::uint32_t cell);
    void flood();

    Vector3 origin_ = Vector3::Zero();
    float per_cell_ = 0;  // [1/m]
    std::array<std::uint32_t, 3> counts_{};
    std::vector<Cell> cells_;
    std::vector<std::uint32_t> open_;
};

}  // namespace weft
