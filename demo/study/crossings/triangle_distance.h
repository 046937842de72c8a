#pragma once
// Distances of points, segments and triangles, in double precision.

#include <array>
#include <Eigen/Core>

namespace weft::study {

using Corners3 = std::array<Eigen::Vector3d, 3>;

/// Squared distance of a point and a triangle, which may have no area.
[[nodiscard]] double squared_distance(const Eigen::Vector3d& point, const Corners3& triangle);
/// Squared distance of two segments, which may be points.
[[nodiscard]] double squared_distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                      const Eigen::Vector3d& c, const Eigen::Vector3d& d);
/// Squared distance of two triangles that do not cross: from corners to faces and from edges to edges.
[[nodiscard]] double squared_distance(const Corners3& first, const Corners3& second);

}  // namespace weft::study
