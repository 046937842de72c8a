#pragma once
// Cells that lie certainly outside a closed mesh, however its vertices have moved.

#include <array>
#include <cstdint>
#include <vector>

#include "collision/shapes/triangles/triangle_tree.h"

namespace weft {

/// A grid over the mesh's bounding box. A cell is outside if no triangle's box touches it and cells like it
/// connect it to the grid's border.
class OutsideCells {
  public:
    /// Reserves memory. May throw.
    void reserve();
    /// Finds the outside cells. Precondition: reserve().
    void find(const TriangleTree& tree);
    void clear() { outside_.clear(); }
    [[nodiscard]] bool known() const { return !outside_.empty(); }
    /// The point has an outside cell nearer than `distance` [m]: true only if one is found, by 27 probes.
    [[nodiscard]] bool come_near(const Vector3& q, float distance) const;
    [[nodiscard]] std::size_t bytes() const {
        return (touched_.capacity() + outside_.capacity()) * sizeof(Row);
    }

  private:
    static constexpr std::uint32_t words = 2, most = 64 * words;  // cells along the longest side
    using Row = std::array<std::uint64_t, words>;                 // cells along x: a bit to each

    [[nodiscard]] std::uint32_t cell_at(int axis, float place) const;
    [[nodiscard]] bool is_outside(const Vector3& q) const;
    void touch(const TriangleLeaf& leaf);
    bool spread(std::uint32_t y, std::uint32_t z);

    Vector3 origin_ = Vector3::Zero();
    float per_cell_ = 0;  // [1/m]
    std::array<std::uint32_t, 3> counts_{};
    std::vector<Row> touched_, outside_;  // y is fastest
};

}  // namespace weft
