#pragma once
// The triangle of a cloth that is nearest to a point.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/vector.h"
#include "weft/world.h"

namespace weft {

/// A hierarchy of bounding boxes of triangles, halved at medians. It is built in n log^2 n, and a search
/// opens only boxes that may hold a nearer triangle.
///
/// The answer is the least by (distance, number) of all triangles, so it does not depend on the order of the
/// search. It begins at a leaf, the answer's for a point nearby if there is one, which bounds the distance at
/// once, and climbs from there.
class NearestTriangle {
  public:
    explicit NearestTriangle(const ClothView& cloth);

    struct Found {
        std::uint32_t triangle = 0;
        float second = 0, third = 0;  ///< barycentric coordinates of its last two corners
        float distance = 0;           ///< [m]
        std::uint32_t leaf = 0;       ///< where the search for a point nearby should begin
    };
    /// The nearest triangle that faces as `normal` does, or the nearest of all if none of these is within
    /// reach [m]; the lowest number among equally near ones. None: no triangle is within reach. `nearby` is
    /// the leaf of an earlier answer of this; it changes the time only.
    [[nodiscard]] std::optional<Found> to(const Vector3& point, const Vector3& normal, float reach,
                                          std::uint32_t nearby = 0) const;

  private:
    using Box = Eigen::AlignedBox4f;  // x y z and 0: a vector register's width
    /// A triangle as searches read it.
    struct Face {
        Box box;
        std::array<Vector3, 3> corners;
        Vector3 area_normal;
        std::uint32_t triangle;
    };
    /// Children of an inner node are `first` and `first + 1`; a leaf has faces_[first, first + count).
    struct Node {
        Box box;                     // of positions [m]
        Box normals;                 // of unit normals: a search for facing triangles skips others
        std::uint32_t first, count;  // 0: an inner node
        std::uint32_t parent;
    };
    [[nodiscard]] std::vector<std::uint32_t> build(const ClothView& cloth);
    void fit();
    [[nodiscard]] std::optional<Found> search(const Vector3& point, const Vector3* normal, float reach,
                                              std::uint32_t nearby) const;

    std::vector<Face> faces_;  // by leaves
    std::vector<Node> nodes_;
    float rounding_ = 0;  // bounds the error of a distance [m]
};

}  // namespace weft
