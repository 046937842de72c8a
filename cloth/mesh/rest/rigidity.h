#pragma once
// The bending rigidity of woven cloth along its warp, along its weft, and in between.
//
// An orthotropic plate of curvature K has the energy 1/2 K : D K per area. With the rigidities B along the
// warp and r B along the weft, and sqrt(r) B for twist, it is the isotropic plate drawn out along the weft by
// r^(-1/4) (Huber 1923). Rolled up at an angle a to the warp it has B (cos^2 a + sqrt(r) sin^2 a)^2; a narrow
// strip cut at that angle, which may twist as it bends, has B / (cos^2 a + sin^2 a / sqrt(r))^2.

#include <cmath>
#include <numbers>

#include <Eigen/Core>

namespace weft {

using Tensor = Eigen::Vector3d;  ///< a symmetric tensor of the plane: xx, yy, sqrt 2 xy

/// n n^T of a vector.
[[nodiscard]] inline Tensor squared(const Eigen::Vector2d& n) {
    return {n.x() * n.x(), n.y() * n.y(), std::numbers::sqrt2 * n.x() * n.y()};
}

/// D over B: moments per curvature.
using Rigidity = Eigen::Matrix3d;

/// The rigidity of cloth whose warp runs along this unit vector; `ratio` is r.
[[nodiscard]] inline Rigidity rigidity_about(const Eigen::Vector2d& warp, double ratio) {
    const Tensor along = squared(warp), across = squared({-warp.y(), warp.x()});
    const Tensor twist(-std::numbers::sqrt2 * warp.x() * warp.y(), std::numbers::sqrt2 * warp.x() * warp.y(),
                       warp.x() * warp.x() - warp.y() * warp.y());
    return along * along.transpose() + ratio * (across * across.transpose()) +
           std::sqrt(ratio) * (twist * twist.transpose());
}

}  // namespace weft
