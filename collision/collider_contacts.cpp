#include "collision/collider_contacts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>

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

/// All the way: its ends go straight.
bool are_clear(const Capsule& start, const Capsule& end, float reach, const Bounds& bounds) {
    const float far = std::max(start.radius, end.radius) + reach;
    const auto apart = [far](const Vec3& a0, const Vec3& b0, const Vec3& a1, const Vec3& b1,
                             const Bounds& box, float Vec3::*axis) {
        return std::min({a0.*axis, b0.*axis, a1.*axis, b1.*axis}) - far > box.upper.*axis ||
               std::max({a0.*axis, b0.*axis, a1.*axis, b1.*axis}) + far < box.lower.*axis;
    };
    return apart(start.a, start.b, end.a, end.b, bounds, &Vec3::x) ||
           apart(start.a, start.b, end.a, end.b, bounds, &Vec3::y) ||
           apart(start.a, start.b, end.a, end.b, bounds, &Vec3::z);
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

/// The least turn that takes one direction to another; neither need have a length.
Matrix3 turn_between(const Vector3& from, const Vector3& to) {
    const float lengths = std::sqrt(from.squaredNorm() * to.squaredNorm());
    if (!(lengths > 0 && lengths < std::numeric_limits<float>::infinity())) return Matrix3::Identity();
    return Eigen::Quaternionf::FromTwoVectors(from, to).toRotationMatrix();
}

MovingCapsule moving(const Capsule& start, const Capsule& end, const Pace& pace) {
    const Vector3 axis = to_vector(end.b) - to_vector(end.a);
    const Vector3 start_axis = to_vector(start.b) - to_vector(start.a);
    const Vector3 velocity_a = velocity(start.a, end.a, pace), velocity_b = velocity(start.b, end.b, pace);
    // Shorter than rounding of its radius: the inverse of its square may overflow.
    const auto per_square = [](const Vector3& v, float radius) {
        const float squared = v.squaredNorm();
        return squared > 1e-12f * radius * radius ? 1 / squared : 0;
    };
    const float per_length_squared = per_square(axis, end.radius);
    const bool is_sphere = per_length_squared == 0;
    return {.a = to_vector(end.a),
            .axis = axis,
            .per_length_squared = per_length_squared,
            .radius = end.radius,
            .growth = std::clamp((end.radius - start.radius) / pace.h, -pace.fastest, pace.fastest),
            .velocity = velocity_a,
            .difference = velocity_b - velocity_a,
            .across = is_sphere ? Vector3::UnitY() : axis.unitOrthogonal(),
            .start_a = to_vector(start.a),
            .start_axis = start_axis,
            .per_start_length_squared = per_square(start_axis, start.radius),
            .start_radius = start.radius,
            .turn = turn_between(start_axis, axis)};
}

MovingPlane moving(const UnitPlane& start, const UnitPlane& end, const Pace& pace) {
    return {.normal = end.normal,
            .offset = end.offset,
            .advance = (end.offset - start.offset) / pace.h,
            .turn = (end.normal - start.normal) / pace.h,
            .fastest = pace.fastest};
}

/// How far a block's particles see: thickness and what is beyond it.
struct Reach {
    float thickness, beyond;  // [m]
    [[nodiscard]] float all() const { return thickness + beyond; }
};

// use(a moving shape, what is thin of it), unless it is clear of the paths by more than the reach.

/// A particle that moves less against a capsule ends on the side on which it came, within 30 degrees.
float thin_part(const Capsule& capsule, float thickness) {
    return 0.5f * (capsule.radius + thickness);
}

/// How far the capsule's points move in the substep at most; where that is faster than anything may move what
/// it meets, it has jumped, and sweeps nothing.
float swept_way(const Capsule& start, const Capsule& end, const Pace& pace) {
    const auto way = [](const Vec3& a, const Vec3& b) { return (to_vector(b) - to_vector(a)).norm(); };
    const float longest =
        std::max(way(start.a, end.a), way(start.b, end.b)) + std::abs(end.radius - start.radius);
    return longest > pace.fastest * pace.h ? -std::numeric_limits<float>::infinity() : longest;
}

Bounds grown(const Bounds& bounds, float by) {
    const Vector3 margin = Vector3::Constant(by);
    return {to_vec3(to_vector(bounds.lower) - margin), to_vec3(to_vector(bounds.upper) + margin)};
}

template <class Use>
void if_near(const Capsule& start, const Capsule& end, const Pace& pace, const Reach& reach,
             const BlockPaths& paths, const Use& use) {
    if (are_clear(start, end, reach.all(), grown(paths.ends, paths.longest))) return;
    const float thin = thin_part(end, reach.thickness);
    const bool may_pass = swept_way(start, end, pace) + paths.longest > thin;
    if (may_pass || !are_clear(end, end, reach.all(), paths.ends))
        use(moving(start, end, pace), may_pass ? thin : 0);
}

template <class Use>
void if_near(const Plane& start, const Plane& end, const Pace& pace, const Reach& reach,
             const BlockPaths& paths, const Use& use) {
    const UnitPlane unit_end = unit(end);
    if (!are_clear(unit_end, reach.all(), paths.ends)) use(moving(unit(start), unit_end, pace), 0.0f);
}

template <class Use>
void if_near(const Sphere& start, const Sphere& end, const Pace& pace, const Reach& reach,
             const BlockPaths& paths, const Use& use) {
    if_near(as_capsule(start), as_capsule(end), pace, reach, paths, use);
}

template <class Use>
void if_near(const ColliderMotion& motion, float h, const Reach& reach, const BlockPaths& paths,
             const Use& use) {
    const auto if_shape_near = [&]<class Shape>(const Shape& end) {
        if_near(*std::get_if<Shape>(&motion.start.shape), end, {h, motion.fastest}, reach, paths, use);
    };
    std::visit(if_shape_near, motion.end.shape);
}

/// A collider that moves farther than what is thin of it.
struct FastMotion {
    float thin;   // [m]
    Vector3 way;  // of its middle [m]
};
std::optional<FastMotion> fast_motion(const ColliderMotion& motion, float h, float thickness) {
    const Pace pace{h, motion.fastest};
    const auto of_capsule = [&](const Capsule& start, const Capsule& end) -> std::optional<FastMotion> {
        const float thin = thin_part(end, thickness);
        if (!(swept_way(start, end, pace) > thin)) return std::nullopt;
        const Vector3 from = to_vector(start.a) + to_vector(start.b),
                      to = to_vector(end.a) + to_vector(end.b);
        return FastMotion{thin, 0.5f * (to - from)};
    };
    if (const auto* const end = std::get_if<Capsule>(&motion.end.shape))
        return of_capsule(*std::get_if<Capsule>(&motion.start.shape), *end);
    if (const auto* const end = std::get_if<Sphere>(&motion.end.shape))
        return of_capsule(as_capsule(*std::get_if<Sphere>(&motion.start.shape)), as_capsule(*end));
    return std::nullopt;
}

std::uint32_t collide_block(std::span<const ColliderMotion> colliders, float thickness, float friction,
                            float h, std::span<const Vec4> held, std::span<const Vec4> starts,
                            std::span<Vec4> positions, std::span<Vec4> velocities) {
    CollidingBlock block{positions, velocities, held, starts, paths_of(starts, positions)};
    for (const ColliderMotion& motion : colliders)
        if_near(motion, h, {thickness, 0}, block.paths, [&](const auto& moving_shape, float thin) {
            collide(moving_shape, {thickness, friction * motion.end.friction, h, starts.empty() ? 0 : thin},
                    block);
        });
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
                      float friction, float h, std::span<const Vec4> held, std::span<const Vec4> starts,
                      std::span<Vec4> positions, std::span<Vec4> velocities,
                      std::span<std::uint32_t> block_partials) {
    if (colliders.empty()) return 0;
    const auto block = [&](const BlockRange& range) {
        const std::uint32_t size = range.end - range.begin;
        const auto of_block = [&](std::span<const Vec4> all) {
            return all.empty() ? all : all.subspan(range.begin, size);
        };
        return collide_block(colliders, thickness, friction, h, of_block(held), of_block(starts),
                             positions.subspan(range.begin, size), velocities.subspan(range.begin, size));
    };
    return parallel.reduce(static_cast<std::uint32_t>(positions.size()), block_partials, 0u, block,
                           std::plus<>{});
}

std::uint32_t parts_to_meet(Parallel& parallel, std::span<const ColliderMotion> colliders, float thickness,
                            float h, std::uint32_t most, std::span<const Vec4> positions,
                            std::span<const Vec4> velocities, std::span<std::uint32_t> block_partials) {
    std::uint32_t parts = 1;
    for (const ColliderMotion& motion : colliders) {
        const std::optional<FastMotion> fast = fast_motion(motion, h, thickness);
        if (!fast) continue;
        const auto block = [&](const BlockRange& range) {
            const std::uint32_t size = range.end - range.begin;
            const std::span<const Vec4> starts = positions.subspan(range.begin, size);
            NearSurfaces near;
            if (!find_near_surfaces({&motion, 1}, thickness, 0, h, 0, starts, starts, h,
                                    velocities.subspan(range.begin, size), near))
                return 1u;
            float longest = 0;
            for (std::uint32_t i = range.begin; i < range.end; ++i)
                if (positions[i].w > 0)
                    longest = std::max(longest, (h * xyz(velocities[i]) - fast->way).squaredNorm());
            const float wanted = std::ceil(std::sqrt(longest) / (2 * fast->thin));
            return wanted < static_cast<float>(most) ? std::max(static_cast<std::uint32_t>(wanted), 1u)
                                                     : most;
        };
        parts = parallel.reduce(static_cast<std::uint32_t>(positions.size()), block_partials, parts, block,
                                [](std::uint32_t a, std::uint32_t b) { return std::max(a, b); });
    }
    return parts;
}

bool find_near_surfaces(std::span<const ColliderMotion> colliders, float thickness, float friction, float h,
                        float reach, std::span<const Vec4> starts, std::span<const Vec4> positions,
                        float gamma, std::span<const Vec4> velocities, NearSurfaces& near) {
    const auto size = static_cast<std::uint32_t>(positions.size());
    const BlockPaths paths = place(starts, positions, gamma, velocities, near.points);
    bool is_clear = true, found = false;
    for (const ColliderMotion& motion : colliders)
        if_near(motion, h, {thickness, reach}, paths, [&](const auto& moving_shape, float thin) {
            if (is_clear) clear(near, reach);
            is_clear = false;
            const ContactSettings settings{thickness, friction * motion.end.friction, h,
                                           starts.empty() ? 0 : thin};
            found |= find_nearest(moving_shape, settings, reach, starts, size, near);
        });
    return found;
}

}  // namespace weft
