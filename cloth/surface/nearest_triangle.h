#pragma once
// The triangle of a cloth that is nearest to a point.

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/vector.h"
#include "weft/world.h"

namespace weft {

/// A hierarchy of bounding boxes of triangles, halved at medians. It is built in n log^2 n, and a search
/// opens only boxes that may hold a nearer triangle.
class NearestTriangle {
  public:
    /// The view must outlive this.
    explicit NearestTriangle(const ClothView& cloth);

    struct Found {
        std::uint32_t triangle = 0;
        float second = 0, third = 0;  ///< barycentric coordinates of its last two corners
        float distance = 0;           ///< [m]
    };
    /// The nearest triangle that faces as `normal` does, or the nearest of all if none of these is within
    /// reach [m]; the lowest number among equally near ones. None: no triangle is within reach.
    [[nodiscard]] std::optional<Found> to(const Vector3& point, const Vector3& normal, float reach) const;

  private:
    /// Children of an inner node are `first` and `first + 1`; a leaf has order_[first, first + count).
    struct Node {
        Eigen::AlignedBox3f box;      // of positions [m], widened by rounding
        Eigen::AlignedBox3f normals;  // of unit normals: a search for facing triangles skips others
        std::uint32_t first, count;   // 0: an inner node
    };
    void build(std::vector<std::uint32_t> order);
    void fit();
    [[nodiscard]] std::optional<Found> search(const Vector3& point, const Vector3* normal, float reach) const;

    const ClothView& cloth_;
    std::vector<std::uint32_t> order_;  // triangles, by leaves
    std::vector<Node> nodes_;
    float rounding_ = 0;  // bounds the error of a distance [m]
};

}  // namespace weft
