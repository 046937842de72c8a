#include "collision/collider_kernels.h"

#include <algorithm>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/collider_kernels.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "collision/block_lanes-inl.h"
#include "collision/coulomb-inl.h"
#include "engine/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

HWY_INLINE Lanes3 set3(const Vector3& v) {
    return {set(v.x()), set(v.y()), set(v.z())};
}
HWY_INLINE Lanes3 set3(const Vec3& v) {
    return {set(v.x), set(v.y), set(v.z)};
}
HWY_INLINE Lanes4 with_w(const Lanes3& v, Lanes w) {
    return {v.x, v.y, v.z, w};
}
template <class Mask>
HWY_INLINE Lanes4 either(Mask mask, const Lanes4& yes, const Lanes4& no) {
    return with_w(either(mask, xyz(yes), xyz(no)), hn::IfThenElse(mask, yes.w, no.w));
}

struct BoundsLanes {
    Lanes3 lower, upper;

    /// On x86 what is not a number leaves the bounds as they are; elsewhere it may make them not a number.
    HWY_INLINE void add(const Lanes3& p) {
        lower = {hn::Min(p.x, lower.x), hn::Min(p.y, lower.y), hn::Min(p.z, lower.z)};
        upper = {hn::Max(p.x, upper.x), hn::Max(p.y, upper.y), hn::Max(p.z, upper.z)};
    }
    [[nodiscard]] HWY_INLINE Bounds all() const {
        const Tag d;
        const auto least = [&](Lanes v) { return hn::GetLane(hn::MinOfLanes(d, v)); };
        const auto most = [&](Lanes v) { return hn::GetLane(hn::MaxOfLanes(d, v)); };
        return {{least(lower.x), least(lower.y), least(lower.z)},
                {most(upper.x), most(upper.y), most(upper.z)}};
    }
};

HWY_INLINE BoundsLanes no_bounds() {
    const Lanes infinity = set(std::numeric_limits<float>::infinity());
    return {{infinity, infinity, infinity}, {hn::Neg(infinity), hn::Neg(infinity), hn::Neg(infinity)}};
}

Bounds bounds(std::span<const Vec4> positions) {
    BoundsLanes bounds = no_bounds();
    std::size_t i = 0;
    for (; i + part_lanes <= positions.size(); i += part_lanes) bounds.add(xyz(load_rows(&positions[i])));
    for (; i < positions.size(); ++i)
        bounds.add({set(positions[i].x), set(positions[i].y), set(positions[i].z)});
    return bounds.all();
}

/// Where the surface is nearest, lane by lane.
template <class Mask>
struct SurfaceLanes {
    Mask is_near;
    Lanes penetration;  // into what lies nearer than the thickness [m]
    Lanes3 normal;      // of unit length, outward
    Lanes3 velocity;    // [m/s]
};

// Shapes answer, for points p, whether any is near, and then where the surface is. Comparisons are such that
// what is not a number is near nothing.

struct CapsuleLanes {
    const MovingCapsule& shape;
    Lanes thickness, reach_squared;

    CapsuleLanes(const MovingCapsule& shape, float thickness)
        : shape(shape),
          thickness(set(thickness)),
          reach_squared(set((shape.radius + thickness) * (shape.radius + thickness))) {}

    /// Fraction of the way from a to b of the axis point nearest to p.
    [[nodiscard]] HWY_INLINE Lanes along(const Lanes3& from_a) const {
        const Lanes t = hn::Mul(dot(from_a, set3(shape.axis)), set(shape.per_length_squared));
        return hn::Min(hn::Max(t, set(0)), set(1));
    }
    [[nodiscard]] HWY_INLINE auto near(const Lanes3& p) const {
        const Lanes3 from_a = p - set3(shape.a);
        const Lanes3 out = from_a - along(from_a) * set3(shape.axis);
        return hn::Lt(dot(out, out), reach_squared);
    }
    template <class Mask>
    [[nodiscard]] HWY_INLINE SurfaceLanes<Mask> surface(const Lanes3& p, Mask is_near) const {
        const Lanes3 from_a = p - set3(shape.a);
        const Lanes t = along(from_a);
        const Lanes3 out = from_a - t * set3(shape.axis);
        const Lanes length = hn::Sqrt(dot(out, out));
        const Lanes penetration = hn::Sub(thickness, hn::Sub(length, set(shape.radius)));
        const Lanes3 normal = either(hn::Gt(length, set(1e-6f * shape.radius)), hn::Div(set(1), length) * out,
                                     set3(shape.across));
        const Lanes3 of_axis = mul_add(t, set3(shape.difference), set3(shape.velocity));
        return {hn::And(is_near, hn::Gt(penetration, set(0))), penetration, normal,
                mul_add(set(shape.growth), normal, of_axis)};
    }
};

struct PlaneLanes {
    const MovingPlane& shape;
    Lanes thickness;

    PlaneLanes(const MovingPlane& shape, float thickness) : shape(shape), thickness(set(thickness)) {}

    [[nodiscard]] HWY_INLINE Lanes distance(const Lanes3& p) const {
        return hn::Sub(dot(set3(shape.normal), p), set(shape.offset));
    }
    [[nodiscard]] HWY_INLINE auto near(const Lanes3& p) const { return hn::Lt(distance(p), thickness); }
    template <class Mask>
    [[nodiscard]] HWY_INLINE SurfaceLanes<Mask> surface(const Lanes3& p, Mask is_near) const {
        const Lanes3 normal = set3(shape.normal);
        const Lanes turning = hn::Sub(set(shape.advance), dot(set3(shape.turn), p));
        const Lanes speed = hn::Min(hn::Max(turning, set(-shape.fastest)), set(shape.fastest));
        return {is_near, hn::Sub(thickness, distance(p)), normal, speed * normal};
    }
};

/// Takes from the velocity what approaches the surface, and of what slides along it as much as Coulomb's law
/// allows for that normal impulse. The step's motion loses its share of the sliding too: hence no creep at
/// rest.
template <class Shape>
HWY_INLINE void collide_part(const Shape& shape, const ContactSettings& settings, const Lanes3& held,
                             Vec4* positions, Vec4* velocities, std::uint32_t* met, BoundsLanes& bounds) {
    const Tag d;
    const hn::RebindToUnsigned<Tag> du;
    const Lanes zero = set(0);
    const Lanes4 position = load_rows(positions);
    const Lanes3 p = xyz(position);
    const auto may_meet = hn::And(shape.near(p), hn::Gt(position.w, zero));
    if (hn::AllFalse(d, may_meet)) return;

    const auto surface = shape.surface(p, may_meet);
    const Lanes4 velocity = load_rows(velocities);
    const Lanes3 relative = xyz(velocity) - surface.velocity;
    const Lanes approach = hn::Max(zero, hn::Neg(dot(relative, surface.normal)));
    const Lanes3 sliding = mul_add(approach, surface.normal, relative);
    const auto rubs = hn::And(hn::Gt(approach, zero), hn::Eq(dot(held, held), zero));
    const Lanes3 stopped =
        keep_where(rubs, stopped_by_friction(sliding, hn::Mul(set(settings.friction), approach)));
    const Lanes3 kick = approach * surface.normal - stopped;
    const Lanes3 displacement = surface.penetration * surface.normal - set(settings.h) * stopped;
    const Lanes3 moved = either(surface.is_near, p + displacement, p);
    store_rows(moved, position.w, positions);
    store_rows(either(surface.is_near, xyz(velocity) + kick, xyz(velocity)), velocity.w, velocities);
    bounds.add(moved);
    const auto one = hn::IfThenElseZero(hn::RebindMask(du, surface.is_near), hn::Set(du, 1));
    hn::Store(hn::Or(hn::Load(du, met), one), du, met);
}

template <class Shape>
HWY_INLINE void collide_block(const Shape& shape, const ContactSettings& settings, CollidingBlock& block) {
    BoundsLanes bounds{set3(block.bounds.lower), set3(block.bounds.upper)};
    const auto size = static_cast<std::uint32_t>(block.positions.size());
    std::uint32_t i = 0;
    const Lanes3 none = zero3();
    for (; i + part_lanes <= size; i += part_lanes)
        collide_part(shape, settings, block.held.empty() ? none : xyz(load_rows(&block.held[i])),
                     &block.positions[i], &block.velocities[i], &block.met[i], bounds);
    if (i < size) {  // a host's array need not go on to the end of its group; what is added has w = 0
        Vec4 positions[part_lanes] = {}, velocities[part_lanes] = {}, held[part_lanes] = {};
        std::copy(block.positions.begin() + i, block.positions.end(), positions);
        std::copy(block.velocities.begin() + i, block.velocities.end(), velocities);
        if (!block.held.empty()) std::copy(block.held.begin() + i, block.held.end(), held);
        BoundsLanes with_added = bounds;
        collide_part(shape, settings, xyz(load_rows(held)), positions, velocities, &block.met[i], with_added);
        for (std::uint32_t k = 0; k < size - i; ++k) {
            block.positions[i + k] = positions[k];
            block.velocities[i + k] = velocities[k];
            bounds.add({set(positions[k].x), set(positions[k].y), set(positions[k].z)});
        }
    }
    block.bounds = bounds.all();
}

void collide_capsule(const MovingCapsule& capsule, const ContactSettings& settings, CollidingBlock& block) {
    collide_block(CapsuleLanes(capsule, settings.thickness), settings, block);
}

void collide_plane(const MovingPlane& plane, const ContactSettings& settings, CollidingBlock& block) {
    collide_block(PlaneLanes(plane, settings.thickness), settings, block);
}

Bounds place_block(std::span<const Vec4> positions, float gamma, std::span<const Vec4> velocities,
                   BlockLanes& points) {
    BoundsLanes bounds = no_bounds();
    const std::size_t whole_groups = (positions.size() + group_lanes - 1) / group_lanes * group_lanes;
    for (std::uint32_t i = 0; i < whole_groups; i += part_lanes) {
        const Lanes4 position = load_rows(positions.data() + i);
        const Lanes3 point = mul_add(set(gamma), xyz(load_rows(velocities.data() + i)), xyz(position));
        store_lanes({point.x, point.y, point.z, position.w}, points, i);
        bounds.add(point);
    }
    return bounds.all();
}

template <class Shape>
HWY_INLINE bool find_nearest_in(const Shape& shape, const ContactSettings& settings, float reach,
                                std::uint32_t size, NearSurfaces& near) {
    const Tag d;
    bool found = false;
    for (std::uint32_t i = 0; i < size; i += part_lanes) {
        const Lanes3 p = xyz(load_lanes(near.points, i));
        const auto may_meet = shape.near(p);
        if (hn::AllFalse(d, may_meet)) continue;
        const auto surface = shape.surface(p, may_meet);
        const Lanes gap = hn::Sub(set(reach), surface.penetration);
        const Lanes4 before = load_lanes(near.surfaces, i), motion = load_lanes(near.motions, i);
        const auto nearer = hn::And(surface.is_near, hn::Lt(gap, before.w));
        store_lanes(either(nearer, with_w(surface.normal, gap), before), near.surfaces, i);
        store_lanes(either(nearer, with_w(surface.velocity, set(settings.friction)), motion), near.motions,
                    i);
        found = true;
    }
    return found;
}

bool find_nearest_capsule(const MovingCapsule& capsule, const ContactSettings& settings, float reach,
                          std::uint32_t size, NearSurfaces& near) {
    return find_nearest_in(CapsuleLanes(capsule, settings.thickness + reach), settings, reach, size, near);
}

bool find_nearest_plane(const MovingPlane& plane, const ContactSettings& settings, float reach,
                        std::uint32_t size, NearSurfaces& near) {
    return find_nearest_in(PlaneLanes(plane, settings.thickness + reach), settings, reach, size, near);
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace weft {

HWY_EXPORT(bounds);
HWY_EXPORT(collide_capsule);
HWY_EXPORT(collide_plane);
HWY_EXPORT(place_block);
HWY_EXPORT(find_nearest_capsule);
HWY_EXPORT(find_nearest_plane);

Bounds bounds_of(std::span<const Vec4> positions) {
    return HWY_DYNAMIC_DISPATCH(bounds)(positions);
}

void collide(const MovingCapsule& capsule, const ContactSettings& settings, CollidingBlock& block) {
    HWY_DYNAMIC_DISPATCH(collide_capsule)(capsule, settings, block);
}

void collide(const MovingPlane& plane, const ContactSettings& settings, CollidingBlock& block) {
    HWY_DYNAMIC_DISPATCH(collide_plane)(plane, settings, block);
}

Bounds place(std::span<const Vec4> positions, float gamma, std::span<const Vec4> velocities,
             BlockLanes& points) {
    return HWY_DYNAMIC_DISPATCH(place_block)(positions, gamma, velocities, points);
}

bool find_nearest(const MovingCapsule& capsule, const ContactSettings& settings, float reach,
                  std::uint32_t size, NearSurfaces& near) {
    return HWY_DYNAMIC_DISPATCH(find_nearest_capsule)(capsule, settings, reach, size, near);
}

bool find_nearest(const MovingPlane& plane, const ContactSettings& settings, float reach, std::uint32_t size,
                  NearSurfaces& near) {
    return HWY_DYNAMIC_DISPATCH(find_nearest_plane)(plane, settings, reach, size, near);
}

}  // namespace weft
#endif
