#pragma once
// Exact sides of planes, and distances of points, segments and triangles in double precision.

#include <array>
#include <Eigen/Core>

#include "weft/types.h"

namespace weft::study {

/// The sign, -1, 0 or 1, of det(a - d, b - d, c - d), six times the signed volume of the four.
[[nodiscard]] int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The same sign without the floating-point filter that decides nearly all cases; for tests.
[[nodiscard]] int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Distances of points, segments and triangles, in double precision.
using Corners3 = std::array<Eigen::Vector3d, 3>;

/// Squared distance of a point and a triangle, which may have no area.
[[nodiscard]] double squared_distance(const Eigen::Vector3d& point, const Corners3& triangle);
/// Squared distance of two segments, which may be points.
[[nodiscard]] double squared_distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                      const Eigen::Vector3d& c, const Eigen::Vector3d& d);
/// Squared distance of two triangles that do not cross: from corners to faces and from edges to edges.
[[nodiscard]] double squared_distance(const Corners3& first, const Corners3& second);

}  // namespace weft::study
