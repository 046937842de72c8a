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

/// A substep, and the speed that a collider has in it at most.
struct Pace {
    float h, fastest;  // [s], [m/s]
};

Vector3 velocity(const Vec3& from, const Vec3& to, const Pace& pace) {
    const Vector3 way = to_vector(to) - to_vector(from);
    const float length = way.norm();
    return length > pace.fastest * pace.h ? Vector3(way * (pace.fastest / length)) : Vector3(way / pace.h);
}

MovingCapsule moving(const Capsule& start, const Capsule& end, const Pace& pace) {
    const Vector3 axis = to_vector(end.b) - to_vector(end.a);
    const Vector3 velocity_a = velocity(start.a, end.a, pace), velocity_b = velocity(start.b, end.b, pace);
    const float length_squared = axis.squaredNorm();
    // Shorter than rounding of its radius: the inverse of its square may overflow.
    const bool is_sphere = !(length_squared > 1e-12f * end.radius * end.radius);
    return {.a = to_vector(end.a),
            .axis = axis,
            .per_length_squared = is_sphere ? 0 : 1 / length_squared,
            .radius = end.radius,
            .growth = std::clamp((end.radius - start.radius) / pace.h, -pace.fastest, pace.fastest),
            .velocity = velocity_a,
            .difference = velocity_b - velocity_a,
            .across = is_sphere ? Vector3::UnitY() : axis.unitOrthogonal()};
}

MovingPlane moving(const UnitPlane& start, const UnitPlane& end, const Pace& pace) {
    return {.normal = end.normal,
            .offset = end.offset,
            .advance = (end.offset - start.offset) / pace.h,
            .turn = (end.normal - start.normal) / pace.h,
            .fastest = pace.fastest};
}

// use(a moving shape), unless the shape at its end is clear of the bounds by more than `reach`.

template <class Use>
void if_near(const Capsule& start, const Capsule& end, const Pace& pace, float reach, const Bounds& bounds,
             const Use& use) {
    if (!are_clear(end, reach, bounds)) use(moving(start, end, pace));
}

template <class Use>
void if_near(const Plane& start, const Plane& end, const Pace& pace, float reach, const Bounds& bounds,
             const Use& use) {
    const UnitPlane unit_end = unit(end);
    if (!are_clear(unit_end, reach, bounds)) use(moving(unit(start), unit_end, pace));
}

template <class Use>
void if_near(const Sphere& start, const Sphere& end, const Pace& pace, float reach, const Bounds& bounds,
             const Use& use) {
    if_near(as_capsule(start), as_capsule(end), pace, reach, bounds, use);
}

template <class Use>
void if_near(const ColliderMotion& motion, float h, float reach, const Bounds& bounds, const Use& use) {
    const auto if_shape_near = [&]<class Shape>(const Shape& end) {
        if_near(*std::get_if<Shape>(&motion.start.shape), end, {h, motion.fastest}, reach, bounds, use);
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

constexpr float farthest = 1e5f;  // [m]
constexpr float least_radius = 1e-6f, least_normal = 1e-12f, longest_normal = 1e12f, most_friction = 1e6f;

// Written so that what is not a number fails.

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
    if (!(collider.friction >= 0 && collider.friction <= most_friction))
        return out_of_range("Collider::friction", static_cast<double>(collider.friction), "from 0 to 1e6");
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
