#include "collision/colliders/carried.h"

#include <algorithm>
#include <limits>

#include "collision/shapes/held_shape.h"

namespace weft {

namespace {

Vec3 carried(const Vec3& own, const BodyPose& pose) {
    return to_vec3(pose * to_vector(own));
}

Rotation carried(const Rotation& own, const BodyPose& pose) {
    const Eigen::Quaternionf r =
        (pose.rotation * Eigen::Quaternionf(own.w, own.x, own.y, own.z)).normalized();
    return {r.x(), r.y(), r.z(), r.w()};
}

Sphere carried(const Sphere& own, const BodyPose& pose) {
    return {carried(own.center, pose), own.radius};
}

Capsule carried(const Capsule& own, const BodyPose& pose) {
    return {carried(own.a, pose), carried(own.b, pose), own.radius};
}

TaperedCapsule carried(const TaperedCapsule& own, const BodyPose& pose) {
    return {carried(own.a, pose), carried(own.b, pose), own.radius_a, own.radius_b};
}

Plane carried(const Plane& own, const BodyPose& pose) {
    const Vector3 normal = pose.rotation * to_vector(own.normal).stableNormalized();
    return {to_vec3(normal), own.offset + normal.dot(pose.position)};
}

Box carried(const Box& own, const BodyPose& pose) {
    return {carried(own.center, pose), carried(own.rotation, pose), own.half_extents};
}

PlacedShape carried(const PlacedShape& own, const BodyPose& pose) {
    return {own.shape, carried(own.position, pose), carried(own.rotation, pose)};
}

Sphere ball_between(const Vec3& a, const Vec3& b, float radius) {
    const Vector3 from = to_vector(a), to = to_vector(b);
    return {to_vec3(0.5f * (from + to)), radius + 0.5f * (to - from).norm()};
}

Sphere ball(const Sphere& sphere) {
    return sphere;
}
Sphere ball(const Capsule& capsule) {
    return ball_between(capsule.a, capsule.b, capsule.radius);
}
Sphere ball(const TaperedCapsule& capsule) {
    return ball_between(capsule.a, capsule.b, std::max(capsule.radius_a, capsule.radius_b));
}
Sphere ball(const Box& box) {
    return {box.center, to_vector(box.half_extents).norm()};
}
Sphere ball(const Plane& /*plane*/) {
    return {{}, std::numeric_limits<float>::max()};
}

}  // namespace

BodyPose BodyPose::inverse() const {
    const Eigen::Quaternionf back = rotation.conjugate();
    return {-(back * position), back};
}

Sphere ball_around(const Collider& collider, const HeldShape* held) {
    return std::visit(
        [&]<class Kind>(const Kind& shape) {
            if constexpr (std::is_same_v<Kind, PlacedShape>) {
                const auto& box = held->box();
                return Sphere{shape.position, box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).norm()};
            } else {
                return ball(shape);
            }
        },
        collider.shape);
}

Collider carried(const Collider& own, const BodyPose& pose) {
    Collider result = own;
    result.shape = std::visit(
        [&](const auto& shape) -> decltype(Collider::shape) { return carried(shape, pose); }, own.shape);
    return result;
}

}  // namespace weft
