#pragma once
// Rigid motions of a cloth's state, in double precision: a cloth that turns about a far point keeps its
// shape.

#include <Eigen/Geometry>

#include "engine/vector.h"
#include "weft/transform.h"
#include "weft/types.h"

namespace weft {

/// Maps a point x to turn x + shift, and a vector x to turn x.
struct RigidMotion {
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();

    [[nodiscard]] Vector3 point(const Vector3& x) const {
        return (turn * x.cast<double>() + shift).cast<float>();
    }
    [[nodiscard]] Vector3 vector(const Vector3& x) const { return (turn * x.cast<double>()).cast<float>(); }
    [[nodiscard]] Vec3 point(const Vec3& x) const;
    [[nodiscard]] RigidMotion inverse() const;
};

[[nodiscard]] Eigen::Quaterniond unit_quaternion(const Rotation& r);
[[nodiscard]] Rotation rotation_of(const Eigen::Quaterniond& q);

[[nodiscard]] RigidMotion rigid_motion(const Transform& by);

/// A pose after the rigid motion `by`.
[[nodiscard]] Transform moved(const Transform& pose, const RigidMotion& by);

}  // namespace weft
