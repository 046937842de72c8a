#pragma once
// Particles against colliders one by one, as the definitions say it: what the kernels are compared with.

#include <algorithm>
#include <limits>
#include <variant>

#include <Eigen/Geometry>

#include "collision/colliders/collider_contacts.h"
#include "engine/vector.h"

namespace weft::test {

/// Where a collider's surface is nearest to a point at the substep's end.
struct ReferenceSurface {
    float distance;  // negative inside
    Vector3 normal;  // of unit length, outward
    Vector3 velocity;
};

inline ReferenceSurface reference_surface(const Capsule& start, const Capsule& end, float h,
                                          const Vector3& p) {
    const Vector3 a = to_vector(end.a), axis = to_vector(end.b) - a;
    const float squared = axis.squaredNorm();
    const float t = squared > 0 ? std::clamp((p - a).dot(axis) / squared, 0.0f, 1.0f) : 0.0f;
    const Vector3 out = p - (a + t * axis);
    const Vector3 normal = out / out.norm();
    const Vector3 velocity_a = (a - to_vector(start.a)) / h;
    const Vector3 velocity_b = (to_vector(end.b) - to_vector(start.b)) / h;
    const float growth = (end.radius - start.radius) / h;
    return {out.norm() - end.radius, normal, velocity_a + t * (velocity_b - velocity_a) + growth * normal};
}

inline ReferenceSurface reference_surface(const Sphere& start, const Sphere& end, float h, const Vector3& p) {
    return reference_surface(Capsule{start.center, start.center, start.radius},
                             Capsule{end.center, end.center, end.radius}, h, p);
}

/// Of all balls along the axis the nearest: their distance has one least, which is narrowed down.
inline ReferenceSurface reference_surface(const TaperedCapsule& start, const TaperedCapsule& end, float h,
                                          const Vector3& point) {
    using V = Eigen::Vector3d;
    const auto at = [](const Vec3& a, const Vec3& b, double t) -> V {
        return (1 - t) * to_vector(a).cast<double>() + t * to_vector(b).cast<double>();
    };
    const auto radius = [](const TaperedCapsule& shape, double t) {
        return (1 - t) * static_cast<double>(shape.radius_a) + t * static_cast<double>(shape.radius_b);
    };
    const V p = point.cast<double>();
    const auto distance = [&](double t) { return (p - at(end.a, end.b, t)).norm() - radius(end, t); };
    double low = 0, high = 1;
    for (int k = 0; k < 80; ++k) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        (distance(a) < distance(b) ? high : low) = distance(a) < distance(b) ? b : a;
    }
    const double t = 0.5 * (low + high);
    const V normal = (p - at(end.a, end.b, t)).normalized();
    const V velocity =
        (at(end.a, end.b, t) - at(start.a, start.b, t) + (radius(end, t) - radius(start, t)) * normal) /
        static_cast<double>(h);
    return {static_cast<float>(distance(t)), normal.cast<float>(), velocity.cast<float>()};
}

/// Of a box that keeps its size: what is at p was there at the start, too, as the box sees it.
inline ReferenceSurface reference_surface(const Box& start, const Box& end, float h, const Vector3& point) {
    using V = Eigen::Vector3d;
    const auto turn = [](const Rotation& r) {
        return Eigen::Quaternionf(r.w, r.x, r.y, r.z).cast<double>().normalized();
    };
    const V p = point.cast<double>(), center = to_vector(end.center).cast<double>();
    const V half = to_vector(end.half_extents).cast<double>();
    const V q = turn(end.rotation).conjugate() * (p - center);
    const V inside = q.cwiseMin(half).cwiseMax(-half);
    V normal = q - inside;
    double distance = normal.norm();
    if (distance > 0) {
        normal /= distance;
    } else {
        int face = 0;
        distance = -(half - q.cwiseAbs()).minCoeff(&face);
        normal = V::Unit(face) * (q[face] < 0 ? -1 : 1);
    }
    const V before = to_vector(start.center).cast<double>() + turn(start.rotation) * q;
    return {static_cast<float>(distance), (turn(end.rotation) * normal).cast<float>(),
            ((p - before) / static_cast<double>(h)).cast<float>()};
}

/// What a World holds has references of its own.
inline ReferenceSurface reference_surface(const PlacedShape&, const PlacedShape&, float, const Vector3&) {
    return {std::numeric_limits<float>::infinity(), Vector3::UnitY(), Vector3::Zero()};
}

inline ReferenceSurface reference_surface(const Plane& start, const Plane& end, float h, const Vector3& p) {
    const Vector3 from = to_vector(start.normal).normalized(), normal = to_vector(end.normal).normalized();
    const float advance = (end.offset - start.offset) - (normal - from).dot(p);
    return {normal.dot(p) - end.offset, normal, normal * (advance / h)};
}

/// False where the particle is not near.
inline bool reference_collide(const ColliderMotion& motion, float thickness, float friction, float h,
                              Vec4& position, Vec4& velocity) {
    const auto surface_of = [&]<class Shape>(const Shape& end) {
        return reference_surface(std::get<Shape>(motion.start.shape), end, h, xyz(position));
    };
    const ReferenceSurface surface = std::visit(surface_of, motion.end.shape);
    if (!(surface.distance < thickness) || position.w <= 0) return false;
    Vector3 displacement = (thickness - surface.distance) * surface.normal;
    const Vector3 relative = xyz(velocity) - surface.velocity;
    const float approach = -relative.dot(surface.normal);
    if (approach > 0) {
        const Vector3 sliding = relative + approach * surface.normal;
        const float limit = friction * motion.end.friction * approach, speed = sliding.norm();
        const Vector3 stopped = speed > limit ? Vector3(sliding * (limit / speed)) : sliding;
        set_xyz(velocity, xyz(velocity) + approach * surface.normal - stopped);
        displacement -= h * stopped;
    }
    set_xyz(position, xyz(position) + displacement);
    return true;
}

}  // namespace weft::test
