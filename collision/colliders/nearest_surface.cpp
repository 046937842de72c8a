#include "collision/colliders/nearest_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include <Eigen/Geometry>

#include "collision/shapes/held_shape.h"
#include "collision/shapes/moving_shapes.h"

namespace weft {

namespace {

SurfacePoint round(const Vector3& axis_point, const Vector3& axis, float radius, const Vector3& to) {
    const Vector3 out = to - axis_point;
    const float length = out.norm();
    // On the axis every direction across it is outward.
    Vector3 normal = Vector3::UnitY();
    if (length > 1e-6f * radius)
        normal = out / length;
    else if (!axis.isZero(0))
        normal = axis.unitOrthogonal();
    return {axis_point + radius * normal, normal, length - radius};
}

SurfacePoint nearest(const Sphere& sphere, const Vector3& to) {
    return round(to_vector(sphere.center), Vector3::Zero(), sphere.radius, to);
}

SurfacePoint nearest(const Capsule& capsule, const Vector3& to) {
    const Vector3 a = to_vector(capsule.a), axis = to_vector(capsule.b) - a;
    const float squared = axis.squaredNorm();
    const float t = squared > 0 ? std::clamp((to - a).dot(axis) / squared, 0.0f, 1.0f) : 0.0f;
    return round(a + t * axis, axis, capsule.radius, to);
}

SurfacePoint nearest(const TaperedCapsule& capsule, const Vector3& to) {
    const Vector3 a = to_vector(capsule.a), axis = to_vector(capsule.b) - a;
    const float length = axis.norm(), wider = capsule.radius_b - capsule.radius_a;
    float t = wider > 0 ? 1.0f : 0.0f;  // where one end's ball contains the other's
    if (std::abs(wider) < 0.9999f * length) {
        const float k = wider / length, foot = (to - a).dot(axis) / (length * length);
        const float across = (to - a - foot * axis).norm();
        t = std::clamp(foot + k * across / (std::sqrt(1 - k * k) * length), 0.0f, 1.0f);
    }
    return round(a + t * axis, axis, capsule.radius_a + t * wider, to);
}

SurfacePoint nearest(const Box& box, const Vector3& to) {
    const Matrix3 from_own = unit(box.rotation).toRotationMatrix();
    const Vector3 q = from_own.transpose() * (to - to_vector(box.center));
    const Vector3 beyond = q.cwiseAbs() - to_vector(box.half_extents);
    const Vector3 out = beyond.cwiseMax(0);
    Vector3 normal = out;
    float distance = out.norm();
    if (!(distance > 0)) {
        int face = 0;
        distance = beyond.maxCoeff(&face);
        normal = Vector3::Unit(face);
    } else {
        normal /= distance;
    }
    for (int k = 0; k < 3; ++k) normal[k] = std::copysign(normal[k], q[k]);
    normal = from_own * normal;
    return {to - distance * normal, normal, distance};
}

SurfacePoint nearest(const Plane& plane, const Vector3& to) {
    const Vector3 normal = to_vector(plane.normal).stableNormalized();
    const float distance = normal.dot(to) - plane.offset;
    return {to - distance * normal, normal, distance};
}

SurfacePoint nearest(const PlacedShape& placed, const HeldShape& held, const Vector3& to, float sight) {
    const Matrix3 from_own = unit(placed.rotation).toRotationMatrix();
    const Vec3 own = to_vec3(from_own.transpose() * (to - to_vector(placed.position)));
    Vec4 found{};
    find_surfaces(held, {&own, 1}, sight, {&found, 1});
    if (!(found.w < sight)) return {to, Vector3::UnitY(), std::numeric_limits<float>::infinity()};
    const Vector3 normal = from_own * xyz(found);
    return {to - found.w * normal, normal, found.w};
}

}  // namespace

SurfacePoint nearest_surface(const Collider& collider, const Vector3& to, const HeldShape* held,
                             float sight) {
    return std::visit(
        [&]<class Kind>(const Kind& shape) {
            if constexpr (std::is_same_v<Kind, PlacedShape>)
                return nearest(shape, *held, to, sight);
            else
                return nearest(shape, to);
        },
        collider.shape);
}

}  // namespace weft
