#pragma once
// Triangles of the surface where a function on a grid is 0.

#include <array>
#include <vector>

#include "engine/vector.h"
#include "weft/mesh.h"

namespace weft::demo {

/// Values at the corners of a grid of cubes.
class CornerGrid {
  public:
    /// Covers the box and at least a cell beyond it; all corners have the value `outside`.
    CornerGrid(const Eigen::AlignedBox3f& box, float cell, float outside);

    /// Calls f(corner's place, its index) for the corners within a box.
    template <class F>
    void for_corners_in(const Eigen::AlignedBox3f& box, const F& f) const {
        const std::array<std::size_t, 3> low = corner_before(box.min()), high = corner_before(box.max());
        for (std::size_t z = low[2]; z <= high[2]; ++z)
            for (std::size_t y = low[1]; y <= high[1]; ++y)
                for (std::size_t x = low[0]; x <= high[0]; ++x) f(place(x, y, z), index(x, y, z));
    }
    [[nodiscard]] std::vector<float>& values() { return values_; }

    /// The surface, counter-clockwise seen from where values are positive: a vertex in each cell that it
    /// passes, in the mean of where it passes the cell's edges (Gibson, "Constrained elastic surface nets",
    /// 1998). It is closed if values on the grid's border are positive: each edge has as many triangles on
    /// one side as on the other, mostly one.
    [[nodiscard]] Mesh surface() const;

  private:
    [[nodiscard]] std::size_t index(std::size_t x, std::size_t y, std::size_t z) const {
        return x + corners_[0] * (y + corners_[1] * z);
    }
    [[nodiscard]] Vector3 place(std::size_t x, std::size_t y, std::size_t z) const {
        return origin_ + cell_ * Vector3(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
    }
    [[nodiscard]] std::array<std::size_t, 3> corner_before(const Vector3& point) const;
    [[nodiscard]] Vector3 middle_of_crossings(std::size_t x, std::size_t y, std::size_t z,
                                              int& crossings) const;

    Vector3 origin_;
    float cell_;
    std::array<std::size_t, 3> corners_{};
    std::vector<float> values_;
};

}  // namespace weft::demo
