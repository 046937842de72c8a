#include "collision/nearest_surface.h"

#include <algorithm>
#include <variant>

#include <Eigen/Geometry>

namespace weft {

namespace {

SurfacePoint round(const Vector3& axis_point, const Vector3& axis, float radius, const Vector3& to) {
    const Vector3 out = to - axis_point;
    const float length = out.norm();
    // On the axis every way across it leads out.
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

SurfacePoint nearest(const Plane& plane, const Vector3& to) {
    const Vector3 normal = to_vector(plane.normal).stableNormalized();
    const float distance = normal.dot(to) - plane.offset;
    return {to - distance * normal, normal, distance};
}

}  // namespace

SurfacePoint nearest_surface(const Collider& collider, const Vector3& to) {
    return std::visit([&](const auto& shape) { return nearest(shape, to); }, collider.shape);
}

}  // namespace weft
