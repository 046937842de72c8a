// Blocks of particles, and single points, against shapes that the World holds.

#include "collision/collider_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/shapes/held_kernels.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "collision/shapes/block_kernels-inl.h"
#include "collision/shapes/held_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

void collide_held(const MovingHeld& held, const ContactSettings& settings, CollidingBlock& block) {
    // What lies at the thickness is not to be looked for from deep inside.
    constexpr float beyond = 4e-3f;
    const OwnHeld own{*held.shape, {settings.thickness + settings.meeting.way + beyond}, held.rate};
    collide_block(BodyLanes(held.space, own, settings.thickness), settings, block);
}

bool nearest_of_held(const MovingHeld& held, const NearestSought& sought, NearSurfaces& near) {
    // The equation leaves to collide() what is deep inside.
    const OwnHeld own{
        *held.shape, {sought.all() + sought.settings.meeting.way, sought.reach == 0}, held.rate};
    return find_nearest_in_block(BodyLanes(held.space, own, sought.all()), sought, near);
}

void find_surfaces_of(const HeldShape& shape, std::span<const Vec3> points, float sight,
                      std::span<Vec4> surfaces) {
    const OwnHeld own{shape, {sight}, 0};
    for (std::size_t first = 0; first < points.size(); first += part_lanes) {
        const std::size_t count = std::min<std::size_t>(part_lanes, points.size() - first);
        LaneByLane of_points;
        for (std::size_t k = 0; k < part_lanes; ++k)
            of_points.set_lane(static_cast<std::uint32_t>(k),
                               to_vector(points[first + std::min(k, count - 1)]), 0);
        const Lanes3 q = xyz(of_points.lanes());
        const OwnSurface found = own.nearest(q, hn::Eq(set(0), set(0)));
        const LaneByLane out(found.normal, found.distance);
        for (std::uint32_t k = 0; k < count; ++k) surfaces[first + k] = to_vec4(out.vector(k), out.w[k]);
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace weft {

HWY_EXPORT(collide_held);
HWY_EXPORT(nearest_of_held);
HWY_EXPORT(find_surfaces_of);

void collide(const MovingHeld& held, const ContactSettings& settings, CollidingBlock& block) {
    HWY_DYNAMIC_DISPATCH(collide_held)(held, settings, block);
}
bool find_nearest(const MovingHeld& held, const NearestSought& sought, NearSurfaces& near) {
    return HWY_DYNAMIC_DISPATCH(nearest_of_held)(held, sought, near);
}
void find_surfaces(const HeldShape& shape, std::span<const Vec3> points, float sight,
                   std::span<Vec4> surfaces) {
    HWY_DYNAMIC_DISPATCH(find_surfaces_of)(shape, points, sight, surfaces);
}

}  // namespace weft
#endif
