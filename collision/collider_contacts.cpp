#include "collision/collider_contacts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include <Eigen/Geometry>

#include "collision/collider_kernels.h"
#include "engine/error_text.h"

namespace weft {

namespace {

struct UnitPlane {
    Vector3 normal;
    float offset;
};
UnitPlane unit(const Plane& plane) {
    return {to_vector(plane.normal).stableNormalized(), plane.offset};
}

// Whether a shape is clear of all that lies in the bounds, by more than `reach`: first and cheapest. Bounds
// that are not numbers are clear of nothing.

bool are_clear(const Capsule& capsule, float reach, const Bounds& bounds) {
    const float far = capsule.radius + reach;
    const auto apart = [far](float a, float b, float lower, float upper) {
        return std::min(a, b) - far > upper || std::max(a, b) + far < lower;
    };
    const Vec3 &lower = bounds.lower, &upper = bounds.upper;
    return apart(capsule.a.x, capsule.b.x, lower.x, upper.x) ||
           apart(capsule.a.y, capsule.b.y, lower.y, upper.y) ||
           apart(capsule.a.z, capsule.b.z, lower.z, upper.z);
}

bool are_clear(const UnitPlane& plane, float reach, const Bounds& bounds) {
    const Vector3 nearest =
        (plane.normal.array() > 0).select(to_vector(bounds.lower), to_vector(bounds.upper));
    return plane.normal.dot(nearest) - plane.offset > reach;
}

Capsule as_capsule(const Sphere& sphere) {
    return {sphere.center, sphere.center, sphere.radius};
}

MovingCapsule moving(const Capsule& start, const Capsule& end, float h) {
    const Vector3 axis = to_vector(end.b) - to_vector(end.a);
    const Vector3 velocity_a = (to_vector(end.a) - to_vector(start.a)) / h;
    const Vector3 velocity_b = (to_vector(end.b) - to_vector(start.b)) / h;
    const float length_squared = axis.squaredNorm();
    const bool is_sphere = !(length_squared > 0);
    return {.a = to_vector(end.a),
            .axis = axis,
            .per_length_squared = is_sphere ? 0 : 1 / length_squared,
            .radius = end.radius,
            .growth = (end.radius - start.radius) / h,
            .velocity = velocity_a,
            .difference = velocity_b - velocity_a,
            .across = is_sphere ? Vector3::UnitY() : axis.unitOrthogonal()};
}

MovingPlane moving(const UnitPlane& start, const UnitPlane& end, float h) {
    return {.normal = end.normal,
            .offset = end.offset,
            .advance = (end.offset - start.offset) / h,
            .turn = (end.normal - start.normal) / h};
}

// use(a moving shape), unless the shape at its end is clear of the bounds by more than `reach`.

template <class Use>
void if_near(const Capsule& start, const Capsule& end, float h, float reach, const Bounds& bounds,
             const Use& use) {
    if (!are_clear(end, reach, bounds)) use(moving(start, end, h));
}

template <class Use>
void if_near(const Plane& start, const Plane& end, float h, float reach, const Bounds& bounds,
             const Use& use) {
    const UnitPlane unit_end = unit(end);
    if (!are_clear(unit_end, reach, bounds)) use(moving(unit(start), unit_end, h));
}

template <class Use>
void if_near(const Sphere& start, const Sphere& end, float h, float reach, const Bounds& bounds,
             const Use& use) {
    if_near(as_capsule(start), as_capsule(end), h, reach, bounds, use);
}

template <class Use>
void if_near(const ColliderMotion& motion, float h, float reach, const Bounds& bounds, const Use& use) {
    const auto if_shape_near = [&]<class Shape>(const Shape& end) {
        if_near(*std::get_if<Shape>(&motion.start.shape), end, h, reach, bounds, use);
    };
    std::visit(if_shape_near, motion.end.shape);
}

std::uint32_t collide_block(std::span<const ColliderMotion> colliders, float thickness, float friction,
                            float h, std::span<const Vec4> held, std::span<Vec4> positions,
                            std::span<Vec4> velocities) {
    CollidingBlock block{positions, velocities, held, bounds_of(positions)};
    for (const ColliderMotion& motion : colliders) {
        const ContactSettings settings{thickness, friction * motion.end.friction, h};
        if_near(motion, h, thickness, block.bounds,
                [&](const auto& moving_shape) { collide(moving_shape, settings, block); });
    }
    return std::accumulate(block.met.begin(), block.met.end(), 0u);
}

void clear(NearSurfaces& near, float reach) {
    for (BlockLanes* lanes : {&near.surfaces, &near.motions})
        for (auto* component : {&lanes->x, &lanes->y, &lanes->z, &lanes->w}) component->fill(0);
    near.surfaces.w.fill(reach);
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
                      float friction, float h, std::span<const Vec4> held, std::span<Vec4> positions,
                      std::span<Vec4> velocities, std::span<std::uint32_t> block_partials) {
    if (colliders.empty()) return 0;
    const auto block = [&](const BlockRange& range) {
        const std::uint32_t size = range.end - range.begin;
        const auto block_held = held.empty() ? held : held.subspan(range.begin, size);
        return collide_block(colliders, thickness, friction, h, block_held,
                             positions.subspan(range.begin, size), velocities.subspan(range.begin, size));
    };
    return parallel.reduce(static_cast<std::uint32_t>(positions.size()), block_partials, 0u, block,
                           std::plus<>{});
}

bool find_near_surfaces(std::span<const ColliderMotion> colliders, float thickness, float friction, float h,
                        float reach, std::span<const Vec4> positions, float gamma,
                        std::span<const Vec4> velocities, NearSurfaces& near) {
    const auto size = static_cast<std::uint32_t>(positions.size());
    const Bounds bounds = place(positions, gamma, velocities, near.points);
    bool is_clear = true, found = false;
    for (const ColliderMotion& motion : colliders) {
        const ContactSettings settings{thickness, friction * motion.end.friction, h};
        if_near(motion, h, thickness + reach, bounds, [&](const auto& moving_shape) {
            if (is_clear) clear(near, reach);
            is_clear = false;
            found |= find_nearest(moving_shape, settings, reach, size, near);
        });
    }
    return found;
}

}  // namespace weft
