// Validation of colliders, and interpolation between two.

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "collision/shapes/collider_motion.h"
#include "collision/shapes/moving_shapes.h"
#include "collision/shapes/ranges.h"
#include "engine/error_text.h"

namespace weft {

namespace {

constexpr float least_radius = 1e-6f, least_normal = 1e-12f, longest_normal = 1e12f, most_friction = 1e6f,
                most_thickness = 10;

// Comparisons are written so that a value that is not a number fails.

Result<void> validate_point(const char* name, const Vec3& point) {
    const auto is_near = [](float coordinate) { return std::abs(coordinate) <= farthest; };
    if (!(is_near(point.x) && is_near(point.y) && is_near(point.z)))
        return out_of_range(name, point, "from -1e5 to 1e5 m on each axis");
    return {};
}

Result<void> validate_radius(const char* name, float radius) {
    if (!(radius >= least_radius && radius <= farthest))
        return out_of_range(name, static_cast<double>(radius), "from 1e-6 to 1e5 m");
    return {};
}

Result<void> validate_shape(const Sphere& sphere) {
    if (auto center = validate_point("Sphere::center", sphere.center); !center) return center;
    return validate_radius("Sphere::radius", sphere.radius);
}

Result<void> validate_shape(const Capsule& capsule) {
    if (auto a = validate_point("Capsule::a", capsule.a); !a) return a;
    if (auto b = validate_point("Capsule::b", capsule.b); !b) return b;
    return validate_radius("Capsule::radius", capsule.radius);
}

Result<void> validate_shape(const Plane& plane) {
    const float length = to_vector(plane.normal).stableNorm();
    if (!(is_finite(plane.normal) && length >= least_normal && length <= longest_normal))
        return out_of_range("Plane::normal", plane.normal, "finite and of a length from 1e-12 to 1e12");
    if (!(std::abs(plane.offset) <= farthest))
        return out_of_range("Plane::offset", static_cast<double>(plane.offset), "from -1e5 to 1e5 m");
    return {};
}

Result<void> validate_shape(const TaperedCapsule& capsule) {
    if (auto a = validate_point("TaperedCapsule::a", capsule.a); !a) return a;
    if (auto b = validate_point("TaperedCapsule::b", capsule.b); !b) return b;
    if (auto radius = validate_radius("TaperedCapsule::radius_a", capsule.radius_a); !radius) return radius;
    return validate_radius("TaperedCapsule::radius_b", capsule.radius_b);
}

Result<void> validate_shape(const Box& box) {
    if (auto center = validate_point("Box::center", box.center); !center) return center;
    if (auto turn = validate_rotation("Box::rotation", box.rotation); !turn) return turn;
    for (const float half : {box.half_extents.x, box.half_extents.y, box.half_extents.z})
        if (!(half >= least_radius && half <= farthest))
            return out_of_range("Box::half_extents", box.half_extents, "from 1e-6 to 1e5 m on each axis");
    return {};
}

Result<void> validate_shape(const PlacedShape& placed) {
    if (auto at = validate_point("PlacedShape::position", placed.position); !at) return at;
    return validate_rotation("PlacedShape::rotation", placed.rotation);
}

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
    if (!(collider.friction >= 0 && collider.friction <= most_friction))
        return out_of_range("Collider::friction", static_cast<double>(collider.friction), "from 0 to 1e6");
    if (!(collider.thickness >= 0 && collider.thickness <= most_thickness))
        return out_of_range("Collider::thickness", static_cast<double>(collider.thickness), "from 0 to 10 m");
    if (!(collider.restitution >= 0 && collider.restitution <= 1))
        return out_of_range("Collider::restitution", static_cast<double>(collider.restitution),
                            "from 0 to 1");
    return std::visit([](const auto& shape) { return validate_shape(shape); }, collider.shape);
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
