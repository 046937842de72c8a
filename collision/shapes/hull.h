#pragma once
// The convex hull of points.

#include <span>
#include <vector>

#include "collision/shapes/triangles/triangle_tree.h"
#include "weft/error.h"

namespace weft {

struct HullMesh {
    std::vector<Vec3> vertices;  ///< the input points that are corners
    std::vector<Corners> triangles;
};

/// Error: as at ConvexHull.
[[nodiscard]] Result<HullMesh> hull_of(std::span<const Vec3> points);

}  // namespace weft
