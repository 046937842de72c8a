#include "collision/colliders/collider_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/colliders/collider_kernels.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "collision/colliders/block_kernels-inl.h"
#include "collision/shapes/body_lanes-inl.h"
#include "collision/shapes/round_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

BlockPaths paths(std::span<const Vec4> starts, std::span<const Vec4> positions) {
    const Vec4* const from = (starts.empty() ? positions : starts).data();
    PathsLanes paths = no_paths();
    std::size_t i = 0;
    for (; i + part_lanes <= positions.size(); i += part_lanes)
        paths.add(xyz(load_rows(from + i)), xyz(load_rows(&positions[i])));
    for (; i < positions.size(); ++i) paths.add(set3(from[i]), set3(positions[i]));
    return paths.all();
}

// Each shape's kernel is compiled as a function of its own.

void collide_capsule(const MovingCapsule& capsule, const ContactSettings& settings, CollidingBlock& block) {
    collide_block(RoundLanes(capsule, settings.thickness), settings, block);
}
void collide_tapered(const MovingTaperedCapsule& capsule, const ContactSettings& settings,
                     CollidingBlock& block) {
    collide_block(RoundLanes(capsule, settings.thickness), settings, block);
}
void collide_plane(const MovingPlane& plane, const ContactSettings& settings, CollidingBlock& block) {
    collide_block(PlaneLanes(plane, settings.thickness), settings, block);
}
void collide_box(const MovingBox& box, const ContactSettings& settings, CollidingBlock& block) {
    collide_block(BodyLanes(box.space, OwnBox{box}, settings.thickness), settings, block);
}

BlockPaths place_block(std::span<const Vec4> starts, std::span<const Vec4> positions, float gamma,
                       std::span<const Vec4> velocities, BlockLanes& points) {
    PathsLanes paths = no_paths();
    const std::size_t whole_groups = (positions.size() + group_lanes - 1) / group_lanes * group_lanes;
    for (std::uint32_t i = 0; i < whole_groups; i += part_lanes) {
        const Lanes4 position = load_rows(positions.data() + i);
        const Lanes3 point = mul_add(set(gamma), xyz(load_rows(velocities.data() + i)), xyz(position));
        store_lanes({point.x, point.y, point.z, position.w}, points, i);
        paths.add(starts.empty() ? point : xyz(load_rows(starts.data() + i)), point);
    }
    return paths.all();
}

bool nearest_of_capsule(const MovingCapsule& capsule, const NearestSought& sought, NearSurfaces& near) {
    return find_nearest_in_block(RoundLanes(capsule, sought.all()), sought, near);
}
bool nearest_of_tapered(const MovingTaperedCapsule& capsule, const NearestSought& sought,
                        NearSurfaces& near) {
    return find_nearest_in_block(RoundLanes(capsule, sought.all()), sought, near);
}
bool nearest_of_plane(const MovingPlane& plane, const NearestSought& sought, NearSurfaces& near) {
    return find_nearest_in_block(PlaneLanes(plane, sought.all()), sought, near);
}
bool nearest_of_box(const MovingBox& box, const NearestSought& sought, NearSurfaces& near) {
    return find_nearest_in_block(BodyLanes(box.space, OwnBox{box}, sought.all()), sought, near);
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace weft {

HWY_EXPORT(paths);
HWY_EXPORT(collide_capsule);
HWY_EXPORT(collide_tapered);
HWY_EXPORT(collide_plane);
HWY_EXPORT(collide_box);
HWY_EXPORT(place_block);
HWY_EXPORT(nearest_of_capsule);
HWY_EXPORT(nearest_of_tapered);
HWY_EXPORT(nearest_of_plane);
HWY_EXPORT(nearest_of_box);

BlockPaths paths_of(std::span<const Vec4> starts, std::span<const Vec4> positions) {
    return HWY_DYNAMIC_DISPATCH(paths)(starts, positions);
}

void collide(const MovingCapsule& capsule, const ContactSettings& settings, CollidingBlock& block) {
    HWY_DYNAMIC_DISPATCH(collide_capsule)(capsule, settings, block);
}
void collide(const MovingTaperedCapsule& capsule, const ContactSettings& settings, CollidingBlock& block) {
    HWY_DYNAMIC_DISPATCH(collide_tapered)(capsule, settings, block);
}
void collide(const MovingPlane& plane, const ContactSettings& settings, CollidingBlock& block) {
    HWY_DYNAMIC_DISPATCH(collide_plane)(plane, settings, block);
}
void collide(const MovingBox& box, const ContactSettings& settings, CollidingBlock& block) {
    HWY_DYNAMIC_DISPATCH(collide_box)(box, settings, block);
}

BlockPaths place(std::span<const Vec4> starts, std::span<const Vec4> positions, float gamma,
                 std::span<const Vec4> velocities, BlockLanes& points) {
    return HWY_DYNAMIC_DISPATCH(place_block)(starts, positions, gamma, velocities, points);
}

bool find_nearest(const MovingCapsule& capsule, const NearestSought& sought, NearSurfaces& near) {
    return HWY_DYNAMIC_DISPATCH(nearest_of_capsule)(capsule, sought, near);
}
bool find_nearest(const MovingTaperedCapsule& capsule, const NearestSought& sought, NearSurfaces& near) {
    return HWY_DYNAMIC_DISPATCH(nearest_of_tapered)(capsule, sought, near);
}
bool find_nearest(const MovingPlane& plane, const NearestSought& sought, NearSurfaces& near) {
    return HWY_DYNAMIC_DISPATCH(nearest_of_plane)(plane, sought, near);
}
bool find_nearest(const MovingBox& box, const NearestSought& sought, NearSurfaces& near) {
    return HWY_DYNAMIC_DISPATCH(nearest_of_box)(box, sought, near);
}

}  // namespace weft
#endif
