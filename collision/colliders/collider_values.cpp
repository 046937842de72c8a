// Validation of colliders, and interpolation between two.

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "collision/shapes/collider_fields.h"
#include "collision/shapes/collider_motion.h"
#include "collision/shapes/field_checks.h"
#include "collision/shapes/moving_shapes.h"

namespace weft {

namespace {

float blend(float from, float to, float t) {
    return from + t * (to - from);
}

Vec3 blend(const Vec3& from, const Vec3& to, float t) {
    return to_vec3(to_vector(from) + t * (to_vector(to) - to_vector(from)));
}

Sphere blend(const Sphere& from, const Sphere& to, float t) {
    return {blend(from.center, to.center, t), blend(from.radius, to.radius, t)};
}

Capsule blend(const Capsule& from, const Capsule& to, float t) {
    return {blend(from.a, to.a, t), blend(from.b, to.b, t), blend(from.radius, to.radius, t)};
}

Plane blend(const Plane& from, const Plane& to, float t) {
    const UnitPlane start = unit(from), end = unit(to);
    const Vector3 normal = start.normal + t * (end.normal - start.normal);
    // Half way to the opposite normal the blend is zero: the plane then flips at once.
    const Vector3 sound = normal.squaredNorm() > 1e-12f ? Vector3(normal.normalized()) : end.normal;
    return {to_vec3(sound), blend(start.offset, end.offset, t)};
}

TaperedCapsule blend(const TaperedCapsule& from, const TaperedCapsule& to, float t) {
    return {blend(from.a, to.a, t), blend(from.b, to.b, t), blend(from.radius_a, to.radius_a, t),
            blend(from.radius_b, to.radius_b, t)};
}

/// Slerp, the shorter way round (Shoemake 1985). A rotation that does not change keeps its bytes.
Rotation blend(const Rotation& from, const Rotation& to, float t) {
    if (from.x == to.x && from.y == to.y && from.z == to.z && from.w == to.w) return to;
    const Eigen::Quaternionf between = unit(from).slerp(t, unit(to)).normalized();
    return {between.x(), between.y(), between.z(), between.w()};
}

Box blend(const Box& from, const Box& to, float t) {
    return {blend(from.center, to.center, t), blend(from.rotation, to.rotation, t),
            blend(from.half_extents, to.half_extents, t)};
}

PlacedShape blend(const PlacedShape& from, const PlacedShape& to, float t) {
    return {to.shape, blend(from.position, to.position, t), blend(from.rotation, to.rotation, t)};
}

}  // namespace

Result<void> validate_rotation(const std::string& name, const Rotation& rotation) {
    const double length =
        Eigen::Vector4f(rotation.x, rotation.y, rotation.z, rotation.w).cast<double>().norm();
    if (!(length >= 1e-6 && length <= 1e6))
        return out_of_range("the length of " + name, length, "from 1e-6 to 1e6");
    return {};
}

Rotation normalized(const Rotation& rotation) {
    const Eigen::Quaternionf r = unit(rotation);
    return {r.x(), r.y(), r.z(), r.w()};
}

Collider normalized(Collider collider) {
    if (auto* const box = std::get_if<Box>(&collider.shape)) box->rotation = normalized(box->rotation);
    if (auto* const placed = std::get_if<PlacedShape>(&collider.shape))
        placed->rotation = normalized(placed->rotation);
    return collider;
}

Result<void> validate(const Collider& collider) {
    if (auto valid = validate_fields(collider); !valid) return valid;
    const auto* const plane = std::get_if<Plane>(&collider.shape);
    if (plane == nullptr) return {};
    // The comparison is written so that a length that is not a number fails.
    const float length = to_vector(plane->normal).stableNorm();
    if (!(length >= 1e-12f && length <= 1e12f))
        return out_of_range("Plane::normal", plane->normal, normal_range.right);
    return {};
}

Collider blend(const Collider& from, const Collider& to, float t) {
    if (t == 1) return to;
    if (t == 0) {
        Collider start = from;
        start.layers = to.layers;
        start.is_trigger = to.is_trigger;
        return start;
    }
    const auto blended = [&]<class Shape>(const Shape& end) -> decltype(Collider::shape) {
        return blend(*std::get_if<Shape>(&from.shape), end, t);
    };
    return {.shape = std::visit(blended, to.shape),
            .friction = blend(from.friction, to.friction, t),
            .thickness = blend(from.thickness, to.thickness, t),
            .restitution = blend(from.restitution, to.restitution, t),
            .layers = to.layers,
            .is_trigger = to.is_trigger};
}

}  // namespace weft
