#pragma once
// A rigid motion of what a cloth's state holds, in double precision: a cloth that turns about a far point
// keeps its shape.

#include <cmath>

#include <Eigen/Geometry>

#include "engine/vector.h"
#include "weft/transform.h"
#include "weft/types.h"

namespace weft {

/// Points go to turn x + shift, vectors to turn x.
struct RigidMotion {
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();

    [[nodiscard]] Vector3 point(const Vector3& x) const {
        return (turn * x.cast<double>() + shift).cast<float>();
    }
    [[nodiscard]] Vector3 vector(const Vector3& x) const { return (turn * x.cast<double>()).cast<float>(); }
    [[nodiscard]] Vec3 point(const Vec3& x) const { return to_vec3(point(to_vector(x))); }
    [[nodiscard]] RigidMotion inverse() const { return {turn.transpose(), -(turn.transpose() * shift)}; }
};

[[nodiscard]] inline Eigen::Quaterniond unit_quaternion(const Rotation& r) {
    const auto wide = [](float v) { return static_cast<double>(v); };
    return Eigen::Quaterniond(wide(r.w), wide(r.x), wide(r.y), wide(r.z)).normalized();
}
[[nodiscard]] inline Rotation rotation_of(const Eigen::Quaterniond& q) {
    const Eigen::Quaternionf r = q.normalized().cast<float>();
    return {r.x(), r.y(), r.z(), r.w()};
}

[[nodiscard]] inline RigidMotion rigid_motion(const Transform& by) {
    return {unit_quaternion(by.rotation).toRotationMatrix(), to_vector(by.translation).cast<double>()};
}

/// The pose of what `by` has moved.
[[nodiscard]] inline Transform moved(const Transform& pose, const RigidMotion& by) {
    return {by.point(pose.translation),
            rotation_of(Eigen::Quaterniond(by.turn) * unit_quaternion(pose.rotation))};
}

}  // namespace weft
