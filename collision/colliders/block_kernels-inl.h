// A block of particles against a shape in registers. Included as engine/simd/lanes-inl.h is.

#if defined(WEFT_COLLISION_COLLIDERS_BLOCK_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_COLLISION_COLLIDERS_BLOCK_KERNELS_INL_H
#undef WEFT_COLLISION_COLLIDERS_BLOCK_KERNELS_INL_H
#else
#define WEFT_COLLISION_COLLIDERS_BLOCK_KERNELS_INL_H
#endif

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/colliders/block_lanes-inl.h"
#include "collision/colliders/collider_kernels.h"
#include "collision/colliders/coulomb-inl.h"
#include "collision/shapes/first_met-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

struct PathsLanes {
    Lanes3 lower, upper;
    Lanes way_squared;

    /// On x86 a NaN leaves the bounds unchanged; elsewhere it may turn them into NaN.
    HWY_INLINE void add(const Lanes3& start, const Lanes3& end) {
        lower = {hn::Min(end.x, lower.x), hn::Min(end.y, lower.y), hn::Min(end.z, lower.z)};
        upper = {hn::Max(end.x, upper.x), hn::Max(end.y, upper.y), hn::Max(end.z, upper.z)};
        const Lanes3 way = end - start;
        way_squared = hn::Max(dot(way, way), way_squared);
    }
    [[nodiscard]] HWY_INLINE BlockPaths all() const {
        const Tag d;
        const auto least = [&](Lanes v) { return hn::GetLane(hn::MinOfLanes(d, v)); };
        const auto most = [&](Lanes v) { return hn::GetLane(hn::MaxOfLanes(d, v)); };
        return {
            {{least(lower.x), least(lower.y), least(lower.z)}, {most(upper.x), most(upper.y), most(upper.z)}},
            std::sqrt(most(way_squared))};
    }
};

HWY_INLINE PathsLanes no_paths() {
    const Lanes infinity = set(std::numeric_limits<float>::infinity());
    return {
        {infinity, infinity, infinity}, {hn::Neg(infinity), hn::Neg(infinity), hn::Neg(infinity)}, set(0)};
}

/// ClothSide's values, from one particle on.
struct OwnValues {
    const float *thickness, *friction;
    const Vec4* normals;  ///< null: both sides have the same friction
};

/// Friction of the side with which the particles touch a surface of this outward normal: see
/// ClothSide::friction_on().
HWY_INLINE Lanes own_friction(const OwnValues& own, float of_back, const Lanes3& normal) {
    const Lanes of_front = load_lanes(own.friction);
    if (own.normals == nullptr) return of_front;
    const auto by_back = hn::Gt(dot(xyz(load_rows(own.normals)), normal), set(0));
    return hn::IfThenElse(by_back, hn::Mul(of_front, set(of_back)), of_front);
}

/// The cloth's greatest thickness, which shapes are made with, less the particles' own [m].
HWY_INLINE Lanes missing_thickness(const ClothSide& cloth, const float* thickness) {
    return hn::Sub(set(cloth.most_thickness), load_lanes(thickness));
}

/// Depth at the substep's start of particles that end inside a shape; 0 where it is too small to count.
/// `beyond`: the shape's thickness less that of cloth and collider.
template <class Shape, class Mask>
HWY_INLINE Lanes found_depth(const Shape& shape, Mask is_free, const SurfaceLanes<Mask>& at_end, Lanes beyond,
                             const FoundDepth& counts, const Vec4* starts) {
    const Lanes least = set(counts.least);
    const auto is_deep = hn::Gt(at_end.penetration, hn::Add(beyond, least));
    const auto asked = hn::And(is_free, hn::And(at_end.is_near, is_deep));
    if (hn::AllFalse(Tag(), asked)) return set(0);
    const auto at_start = shape.surface(shape.carried(xyz(load_rows(starts))), asked);
    const Lanes depth = hn::Sub(at_start.penetration, beyond);
    return hn::IfThenElseZero(hn::And(at_start.is_near, hn::Gt(depth, least)), depth);
}

/// Records that particles from i on are left inside at `depth`, 0 for none; the deepest surface counts.
template <class Mask>
HWY_INLINE void keep_left(Lanes depth, const SurfaceLanes<Mask>& surface, std::uint32_t i,
                          CollidingBlock& block) {
    LeftInside& left = *block.left;
    if (!block.has_left) left.surfaces.w.fill(0);
    block.has_left = true;
    const Lanes4 before = load_lanes(left.surfaces, i);
    const auto deeper = hn::Gt(depth, before.w);
    store_lanes(either(deeper, with_w(surface.normal, depth), before), left.surfaces, i);
    alignas(64) float was[part_lanes];
    hn::Store(before.w, Tag(), was);
    for (std::uint32_t k = 0; k < part_lanes; ++k)
        if (left.surfaces.w[i + k] > was[k]) left.colliders[i + k] = block.collider;
}

template <class Mask>
HWY_INLINE void mark(Mask meets, std::uint32_t* met) {
    const hn::RebindToUnsigned<Tag> du;
    const auto one = hn::IfThenElseZero(hn::RebindMask(du, meets), hn::Set(du, 1));
    hn::Store(hn::Or(hn::Load(du, met), one), du, met);
}

/// Positions at a substep's start; null: not needed. Paths are swept only if `swept`.
struct Starts {
    const Vec4* rows;
    bool swept;
};

/// Removes the velocity's approach to the surface, and as much of its sliding as Coulomb's law allows for
/// that normal impulse. The step's displacement loses the same sliding, so that nothing creeps at rest.
template <class Shape>
HWY_INLINE void collide_part(const Shape& shape, const ContactSettings& settings, const Lanes3& held,
                             const Starts& starts, Vec4* positions, Vec4* velocities, std::uint32_t i,
                             CollidingBlock& block, PathsLanes& paths, const OwnValues& own) {
    const Tag d;
    const Lanes zero = set(0);
    const Lanes4 position = load_rows(positions);
    const Lanes3 p = xyz(position);
    const auto is_free = hn::Gt(position.w, zero);
    const auto may_meet = hn::And(shape.near(p), is_free);
    if (!starts.swept && hn::AllFalse(d, may_meet)) return;

    const Lanes3 start = starts.swept ? xyz(load_rows(starts.rows)) : p;
    auto surface = shape.surface(p, may_meet);
    if constexpr (Shape::is_swept)
        if (starts.swept) surface = first_met(shape, {0, settings.meeting.thin}, start, p, is_free, surface);
    const Lanes missing = missing_thickness(*block.cloth, own.thickness);
    const Lanes found = starts.rows != nullptr
                            ? found_depth(shape, is_free, surface, missing, settings.found, starts.rows)
                            : zero;
    surface.penetration = hn::Sub(surface.penetration, missing);
    surface.is_near = hn::And(surface.is_near, hn::Gt(surface.penetration, zero));
    const auto is_found = hn::Gt(found, zero);
    if (!hn::AllFalse(d, is_found)) {
        mark(is_found, &block.met[i]);
        keep_left(hn::Min(found, surface.penetration), surface, i, block);
        surface.penetration = hn::Sub(surface.penetration, found);
        surface.is_near = hn::And(surface.is_near, hn::Gt(surface.penetration, zero));
    }
    if (hn::AllFalse(d, surface.is_near)) return;
    const Lanes friction =
        hn::Mul(own_friction(own, block.cloth->back_friction, surface.normal), set(settings.friction));
    const Lanes4 velocity = load_rows(velocities);
    const Lanes3 relative = xyz(velocity) - surface.velocity;
    const Lanes approach = hn::Max(zero, hn::Neg(dot(relative, surface.normal)));
    const Lanes3 sliding = mul_add(approach, surface.normal, relative);
    const Lanes bounce = hn::IfThenElseZero(hn::Gt(approach, set(settings.least_bounce)),
                                            hn::Mul(set(settings.restitution), approach));
    const Lanes taken = hn::Add(approach, bounce);
    const auto rubs = hn::And(hn::Gt(approach, zero), hn::Eq(dot(held, held), zero));
    const Lanes3 stopped = keep_where(rubs, stopped_by_friction(sliding, hn::Mul(friction, taken)));
    const Lanes3 kick = taken * surface.normal - stopped;
    const Lanes3 displacement = surface.penetration * surface.normal - set(settings.h) * stopped;
    const Lanes3 moved = either(surface.is_near, p + displacement, p);
    store_rows(moved, position.w, positions);
    store_rows(either(surface.is_near, xyz(velocity) + kick, xyz(velocity)), velocity.w, velocities);
    paths.add(start, moved);
    mark(surface.is_near, &block.met[i]);
}

template <class Shape>
HWY_INLINE void collide_block(const Shape& shape, const ContactSettings& settings, CollidingBlock& block) {
    const Bounds& bounds = block.paths.ends;
    PathsLanes paths{set3(bounds.lower), set3(bounds.upper), set(block.paths.longest * block.paths.longest)};
    const auto size = static_cast<std::uint32_t>(block.positions.size());
    const bool swept = settings.meeting.thin > 0, has_starts = !block.starts.empty();
    const ClothSide& cloth = *block.cloth;
    const bool has_sides = !cloth.normals.empty();
    std::uint32_t i = 0;
    const Lanes3 none = zero3();
    for (; i + part_lanes <= size; i += part_lanes)
        collide_part(shape, settings, block.held.empty() ? none : xyz(load_rows(&block.held[i])),
                     {has_starts ? &block.starts[i] : nullptr, swept}, &block.positions[i],
                     &block.velocities[i], i, block, paths,
                     {&cloth.thickness[i], &cloth.friction[i], has_sides ? &cloth.normals[i] : nullptr});
    if (i < size) {  // a host's array need not fill its last group; padding has w = 0
        Vec4 starts[part_lanes] = {}, positions[part_lanes] = {}, velocities[part_lanes] = {},
             held[part_lanes] = {}, normals[part_lanes] = {};
        std::copy(block.positions.begin() + i, block.positions.end(), positions);
        std::copy(block.velocities.begin() + i, block.velocities.end(), velocities);
        if (!block.held.empty()) std::copy(block.held.begin() + i, block.held.end(), held);
        if (has_starts) std::copy(block.starts.begin() + i, block.starts.end(), starts);
        alignas(64) float thickness[part_lanes] = {}, friction[part_lanes] = {};
        std::copy(cloth.thickness.begin() + i, cloth.thickness.end(), thickness);
        std::copy(cloth.friction.begin() + i, cloth.friction.end(), friction);
        if (has_sides) std::copy(cloth.normals.begin() + i, cloth.normals.end(), normals);
        PathsLanes with_added = paths;
        collide_part(shape, settings, xyz(load_rows(held)), {has_starts ? starts : nullptr, swept}, positions,
                     velocities, i, block, with_added, {thickness, friction, has_sides ? normals : nullptr});
        for (std::uint32_t k = 0; k < size - i; ++k) {
            block.positions[i + k] = positions[k];
            block.velocities[i + k] = velocities[k];
            paths.add(set3(swept ? starts[k] : positions[k]), set3(positions[k]));
        }
    }
    block.paths = paths.all();
}

template <class Mask>
HWY_INLINE void add_inside(Mask is_inside, const Lanes4& surface, const Lanes4& motion, std::uint32_t i,
                           NearSurfaces& near) {
    if (!near.has_inside) near.inside.w.fill(std::numeric_limits<float>::infinity());
    near.has_inside = true;
    const Lanes4 before = load_lanes(near.inside, i), moved = load_lanes(near.inside_motions, i);
    const auto nearer = hn::And(is_inside, hn::Lt(surface.w, before.w));
    store_lanes(either(nearer, surface, before), near.inside, i);
    store_lanes(either(nearer, motion, moved), near.inside_motions, i);
}

template <class Shape>
HWY_INLINE bool find_nearest_in_block(const Shape& shape, const NearestSought& sought, NearSurfaces& near) {
    const Tag d;
    const bool swept = sought.settings.meeting.thin > 0;
    bool found = false;
    for (std::uint32_t i = 0; i < sought.size; i += part_lanes) {
        const Lanes4 point = load_lanes(near.points, i);
        const Lanes3 p = xyz(point);
        const auto may_meet = shape.near(p);
        if (!swept && hn::AllFalse(d, may_meet)) continue;
        auto surface = shape.surface(p, may_meet);
        if constexpr (Shape::is_swept)
            if (swept)
                surface =
                    first_met(shape, {sought.reach, sought.settings.meeting.thin},
                              xyz(load_rows(sought.starts.data() + i)), p, hn::Gt(point.w, set(0)), surface);
        if (hn::AllFalse(d, surface.is_near)) continue;
        const Lanes beyond =
            hn::Add(set(sought.reach), missing_thickness(sought.cloth, &sought.cloth.thickness[i]));
        Lanes gap = hn::Sub(beyond, surface.penetration);
        const OwnValues own{&sought.cloth.thickness[i], &sought.cloth.friction[i],
                            sought.cloth.normals.empty() ? nullptr : &sought.cloth.normals[i]};
        const Lanes friction = hn::Mul(own_friction(own, sought.cloth.back_friction, surface.normal),
                                       set(sought.settings.friction));
        const Lanes4 moves = with_w(
            surface.velocity, sought.told == Told::friction ? friction : set(sought.settings.restitution));
        auto nearer = surface.is_near;
        if (!sought.starts.empty()) {
            const Lanes depth = found_depth(shape, hn::Gt(point.w, set(0)), surface, beyond,
                                            sought.settings.found, sought.starts.data() + i);
            const auto is_inside = hn::Gt(depth, set(0));
            if (!hn::AllFalse(d, is_inside)) {
                gap = hn::Add(gap, depth);
                add_inside(is_inside, with_w(surface.normal, gap), moves, i, near);
                nearer = hn::AndNot(is_inside, nearer);
            }
        }
        const Lanes4 before = load_lanes(near.surfaces, i), motion = load_lanes(near.motions, i);
        nearer = hn::And(nearer, hn::Lt(gap, before.w));
        store_lanes(either(nearer, with_w(surface.normal, gap), before), near.surfaces, i);
        store_lanes(either(nearer, moves, motion), near.motions, i);
        found = true;
    }
    return found;
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
