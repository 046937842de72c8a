#include "collision/colliders/collider_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/colliders/collider_kernels.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "collision/colliders/block_kernels-inl.h"
#include "collision/shapes/body_lanes-inl.h"
#include "collision/shapes/held_lanes-inl.h"
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

/// Bounding box, in a shape's local frame, of points and of their paths of length `way`.
template <class PointAt>
Eigen::AlignedBox3f box_of(const MovingSpace& space, std::uint32_t size, float way, const PointAt& point_at) {
    LaneBox box;
    for (std::uint32_t i = 0; i < size; i += part_lanes) {
        const Lanes3 q = turned(space.to_own, point_at(i) - set3(space.origin));
        const Lanes far = hn::Add(hn::Abs(q.x), hn::Add(hn::Abs(q.y), hn::Abs(q.z)));
        box.add(q, hn::And(hn::Lt(far, set(1e30f)), hn::FirstN(Tag(), size - i)));
    }
    const Eigen::AlignedBox3f found = box.box();
    const Vector3 margin = Vector3::Constant(way + 1e-4f);
    return found.isEmpty() ? found : Eigen::AlignedBox3f(found.min() - margin, found.max() + margin);
}

/// Calls use(own) with the shape, of which only the part within sight of the block is searched.
template <class PointAt, class Use>
auto with_near_part(const MovingHeld& held, const Sight& sight, std::uint32_t size, float way,
                    const PointAt& point_at, const Use& use) {
    const auto* const tree = std::get_if<TriangleTree>(&held.shape->data());
    if (tree == nullptr) return use(OwnHeld{*held.shape, sight, held.rate});
    const NearLeaves leaves(*tree, box_of(held.space, size, way, point_at), sight.far);
    return use(OwnHeld{*held.shape, sight, held.rate, &leaves});
}

/// Calls use(lanes) with a shape that the block's `size` particles meet within `thickness`, on ways that are
/// at most `way` long relative to it [m].
template <class PointAt, class Use>
auto with_lanes(const MovingShape& shape, float thickness, const Sight& sight, std::uint32_t size, float way,
                const PointAt& point_at, const Use& use) {
    const auto visit = [&]<class Kind>(const Kind& kind) {
        if constexpr (std::is_same_v<Kind, MovingPlane>)
            return use(PlaneLanes(kind, thickness));
        else if constexpr (std::is_same_v<Kind, MovingBox>)
            return use(BodyLanes(kind.space, OwnBox{kind}, thickness));
        else if constexpr (std::is_same_v<Kind, MovingHeld>)
            return with_near_part(kind, sight, size, way, point_at, [&](const OwnHeld& own) {
                return use(BodyLanes(kind.space, own, thickness));
            });
        else
            return use(RoundLanes(kind, thickness));
    };
    return std::visit(visit, shape);
}

void collide_shape(const MovingShape& shape, const ContactSettings& settings, CollidingBlock& block) {
    // A margin [m], so that a particle at rest at the thickness starts no search from deep inside.
    constexpr float beyond = 4e-3f;
    const float way = settings.meeting.way;
    const auto size = static_cast<std::uint32_t>(block.positions.size());
    const auto point_at = [&](std::uint32_t i) {
        if (i + part_lanes <= size) return xyz(load_rows(&block.positions[i]));
        Vec4 last[part_lanes] = {};
        std::copy(block.positions.begin() + i, block.positions.end(), last);
        return xyz(load_rows(last));
    };
    with_lanes(shape, settings.thickness, {settings.thickness + way + beyond}, size, way, point_at,
               [&](const auto& lanes) { collide_block(lanes, settings, block); });
}

bool nearest_of_shape(const MovingShape& shape, const NearestSought& sought, NearSurfaces& near) {
    // The equation leaves particles that are deep inside to collide().
    const float way = sought.settings.meeting.way;
    const auto point_at = [&](std::uint32_t i) { return xyz(load_lanes(near.points, i)); };
    return with_lanes(shape, sought.all(), {sought.all() + way, sought.reach == 0}, sought.size, way,
                      point_at,
                      [&](const auto& lanes) { return find_nearest_in_block(lanes, sought, near); });
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

HWY_EXPORT(paths);
HWY_EXPORT(place_block);
HWY_EXPORT(collide_shape);
HWY_EXPORT(nearest_of_shape);
HWY_EXPORT(find_surfaces_of);

BlockPaths paths_of(std::span<const Vec4> starts, std::span<const Vec4> positions) {
    return HWY_DYNAMIC_DISPATCH(paths)(starts, positions);
}
BlockPaths place(std::span<const Vec4> starts, std::span<const Vec4> positions, float gamma,
                 std::span<const Vec4> velocities, BlockLanes& points) {
    return HWY_DYNAMIC_DISPATCH(place_block)(starts, positions, gamma, velocities, points);
}
void collide(const MovingShape& shape, const ContactSettings& settings, CollidingBlock& block) {
    HWY_DYNAMIC_DISPATCH(collide_shape)(shape, settings, block);
}
bool find_nearest(const MovingShape& shape, const NearestSought& sought, NearSurfaces& near) {
    return HWY_DYNAMIC_DISPATCH(nearest_of_shape)(shape, sought, near);
}
void find_surfaces(const HeldShape& shape, std::span<const Vec3> points, float sight,
                   std::span<Vec4> surfaces) {
    HWY_DYNAMIC_DISPATCH(find_surfaces_of)(shape, points, sight, surfaces);
}

}  // namespace weft
#endif
