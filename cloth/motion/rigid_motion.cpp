#include "cloth/motion/rigid_motion.h"

namespace weft {

Vec3 RigidMotion::point(const Vec3& x) const {
    return to_vec3(point(to_vector(x)));
}

RigidMotion RigidMotion::inverse() const {
    return {turn.transpose(), -(turn.transpose() * shift)};
}

Eigen::Quaterniond unit_quaternion(const Rotation& r) {
    const auto wide = [](float v) { return static_cast<double>(v); };
    return Eigen::Quaterniond(wide(r.w), wide(r.x), wide(r.y), wide(r.z)).normalized();
}

Rotation rotation_of(const Eigen::Quaterniond& q) {
    const Eigen::Quaternionf r = q.normalized().cast<float>();
    return {r.x(), r.y(), r.z(), r.w()};
}

RigidMotion rigid_motion(const Transform& by) {
    return {unit_quaternion(by.rotation).toRotationMatrix(), to_vector(by.translation).cast<double>()};
}

Transform moved(const Transform& pose, const RigidMotion& by) {
    return {by.point(pose.translation),
            rotation_of(Eigen::Quaterniond(by.turn) * unit_quaternion(pose.rotation))};
}

}  // namespace weft
