#include "collision/collider_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <Eigen/Geometry>

#include "collision/coulomb.h"
#include "engine/error_text.h"

namespace weft {

namespace {

template <class... F>
struct Overloaded : F... {
    using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

struct UnitPlane {
    Vector3 normal;
    float offset;
};
UnitPlane unit(const Plane& plane) {
    return {to_vector(plane.normal).stableNormalized(), plane.offset};
}

// Shapes over one substep. Each answers, for a point p: how far is the surface at the substep's end (negative
// inside), and, for a point near it, which way is out and how fast does the surface move there.

struct Surface {
    Vector3 normal;    // of unit length, outward
    Vector3 velocity;  // [m/s]
};

/// Spheres (a == b) and capsules.
class RoundedSegment {
  public:
    RoundedSegment(const Capsule& start, const Capsule& end, float h)
        : a_(to_vector(end.a)),
          axis_(to_vector(end.b) - a_),
          radius_(end.radius),
          velocity_a_((a_ - to_vector(start.a)) / h),
          velocity_b_((to_vector(end.b) - to_vector(start.b)) / h),
          growth_((end.radius - start.radius) / h) {
        const float length_squared = axis_.squaredNorm();
        per_length_squared_ = length_squared > 0 ? 1 / length_squared : 0;
    }

    [[nodiscard]] float distance(const Vector3& p) const { return from_axis(p, along(p)).norm() - radius_; }

    [[nodiscard]] Surface surface(const Vector3& p) const {
        const float t = along(p);
        const Vector3 out = from_axis(p, t);
        const float length = out.norm();
        const Vector3 normal = length > 1e-6f * radius_ ? Vector3(out / length) : across_axis();
        return {normal, velocity_a_ + t * (velocity_b_ - velocity_a_) + growth_ * normal};
    }

  private:
    /// Fraction of the way from a to b of the axis point nearest to p.
    [[nodiscard]] float along(const Vector3& p) const {
        return std::clamp((p - a_).dot(axis_) * per_length_squared_, 0.0f, 1.0f);
    }
    [[nodiscard]] Vector3 from_axis(const Vector3& p, float t) const { return p - (a_ + t * axis_); }
    /// The way out for a point on the axis: some fixed direction across it, and up for a sphere.
    [[nodiscard]] Vector3 across_axis() const {
        return per_length_squared_ > 0 ? axis_.unitOrthogonal() : Vector3::UnitY();
    }

    Vector3 a_, axis_;
    float radius_, per_length_squared_;
    Vector3 velocity_a_, velocity_b_;
    float growth_;
};

class HalfSpace {
  public:
    HalfSpace(const Plane& start, const Plane& end, float h)
        : start_(unit(start)), end_(unit(end)), per_h_(1 / h) {}

    [[nodiscard]] float distance(const Vector3& p) const { return end_.normal.dot(p) - end_.offset; }

    /// A plane moves along its normal: how it slides in itself cannot be told from its two ends.
    [[nodiscard]] Surface surface(const Vector3& p) const {
        const float advance = (end_.offset - start_.offset) - (end_.normal - start_.normal).dot(p);
        return {end_.normal, end_.normal * (advance * per_h_)};
    }

  private:
    UnitPlane start_, end_;
    float per_h_;
};

Capsule as_capsule(const Sphere& sphere) {
    return {sphere.center, sphere.center, sphere.radius};
}

/// Calls f with the shape's RoundedSegment or HalfSpace.
template <class F>
void with_shape(const ColliderMotion& motion, float h, const F& f) {
    const auto* start = &motion.start.shape;
    std::visit(Overloaded{
                   [&](const Sphere& end) {
                       f(RoundedSegment(as_capsule(*std::get_if<Sphere>(start)), as_capsule(end), h));
                   },
                   [&](const Capsule& end) { f(RoundedSegment(*std::get_if<Capsule>(start), end, h)); },
                   [&](const Plane& end) { f(HalfSpace(*std::get_if<Plane>(start), end, h)); },
               },
               motion.end.shape);
}

/// Takes from the velocity what approaches the surface, and of what slides along it as much as Coulomb's law
/// allows for that normal impulse. The step's motion loses its share of the sliding too: hence no creep at
/// rest.
void respond(const Surface& surface, float penetration, float friction, float h, Vec4& position,
             Vec4& velocity) {
    Vector3 displacement = penetration * surface.normal;
    const Vector3 relative = xyz(velocity) - surface.velocity;
    const float approach = -relative.dot(surface.normal);
    if (approach > 0) {
        const Vector3 sliding = relative + approach * surface.normal;
        const Vector3 stopped = stopped_by_friction(sliding, friction * approach);
        set_xyz(velocity, xyz(velocity) + approach * surface.normal - stopped);
        displacement -= h * stopped;
    }
    set_xyz(position, xyz(position) + displacement);
}

std::uint32_t collide_block(std::span<const ColliderMotion> colliders, float thickness, float friction,
                            float h, std::span<Vec4> positions, std::span<Vec4> velocities) {
    std::array<bool, block_size> met{};
    for (const ColliderMotion& motion : colliders) {
        const float pair_friction = friction * motion.end.friction;
        with_shape(motion, h, [&](const auto& shape) {
            for (std::size_t i = 0; i < positions.size(); ++i) {
                const Vector3 p = xyz(positions[i]);
                const float distance = shape.distance(p);
                if (!(distance < thickness) || positions[i].w <= 0) continue;
                respond(shape.surface(p), thickness - distance, pair_friction, h, positions[i],
                        velocities[i]);
                met[i] = true;
            }
        });
    }
    return static_cast<std::uint32_t>(std::count(met.begin(), met.end(), true));
}

Result<void> validate_point(const char* name, const Vec3& point) {
    if (!is_finite(point)) return out_of_range(name, point, "finite");
    return {};
}

Result<void> validate_radius(const char* name, float radius) {
    if (!(std::isfinite(radius) && radius > 0))
        return out_of_range(name, static_cast<double>(radius), "finite and > 0 m");
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
    if (!is_finite(plane.normal) || to_vector(plane.normal).isZero(0)) {
        return out_of_range("Plane::normal", plane.normal, "finite and not zero");
    }
    if (!std::isfinite(plane.offset))
        return out_of_range("Plane::offset", static_cast<double>(plane.offset), "finite");
    return {};
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
    // Half way to the opposite normal there is none: the plane then turns over at once.
    const Vector3 sound = normal.squaredNorm() > 1e-12f ? Vector3(normal.normalized()) : end.normal;
    return {to_vec3(sound), blend(start.offset, end.offset, t)};
}

}  // namespace

Result<void> validate(const Collider& collider) {
    if (!(std::isfinite(collider.friction) && collider.friction >= 0)) {
        return out_of_range("Collider::friction", static_cast<double>(collider.friction), "finite and >= 0");
    }
    return std::visit([](const auto& shape) { return validate_shape(shape); }, collider.shape);
}

Collider blend(const Collider& from, const Collider& to, float t) {
    const auto blended = [&]<class Shape>(const Shape& end) -> decltype(Collider::shape) {
        return blend(*std::get_if<Shape>(&from.shape), end, t);
    };
    return {std::visit(blended, to.shape), blend(from.friction, to.friction, t)};
}

std::uint32_t collide(Parallel& parallel, std::span<const ColliderMotion> colliders, float thickness,
                      float friction, float h, std::span<Vec4> positions, std::span<Vec4> velocities,
                      std::span<std::uint32_t> block_partials) {
    if (colliders.empty()) return 0;
    const auto block = [&](const BlockRange& range) {
        const std::uint32_t size = range.end - range.begin;
        return collide_block(colliders, thickness, friction, h, positions.subspan(range.begin, size),
                             velocities.subspan(range.begin, size));
    };
    return parallel.reduce(static_cast<std::uint32_t>(positions.size()), block_partials, 0u, block,
                           std::plus<>{});
}

}  // namespace weft
