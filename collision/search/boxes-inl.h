// Boxes in registers, one to a lane. Included as engine/simd/lanes-inl.h is.

#if defined(WEFT_COLLISION_SEARCH_BOXES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_COLLISION_SEARCH_BOXES_INL_H
#undef WEFT_COLLISION_SEARCH_BOXES_INL_H
#else
#define WEFT_COLLISION_SEARCH_BOXES_INL_H
#endif

#include "collision/search/patch_kernels.h"
#include "engine/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// Boxes, one to a lane, or the same box in every lane.
struct BoxLanes {
    Lanes3 lower, upper;
};

HWY_INLINE BoxLanes join(const BoxLanes& a, const BoxLanes& b) {
    return {minimum(a.lower, b.lower), maximum(a.upper, b.upper)};
}

HWY_INLINE Bounds hull_of_lanes(const BoxLanes& box) {
    const Tag d;
    const auto least = [&](Lanes v) HWY_ATTR { return hn::GetLane(hn::MinOfLanes(d, v)); };
    const auto most = [&](Lanes v) HWY_ATTR { return hn::GetLane(hn::MaxOfLanes(d, v)); };
    return {{least(box.lower.x), least(box.lower.y), least(box.lower.z)},
            {most(box.upper.x), most(box.upper.y), most(box.upper.z)}};
}

HWY_INLINE BoxLanes load_boxes(const Boxes& boxes, std::uint32_t first) {
    return {{load_lanes(boxes.lower_x + first), load_lanes(boxes.lower_y + first),
             load_lanes(boxes.lower_z + first)},
            {load_lanes(boxes.upper_x + first), load_lanes(boxes.upper_y + first),
             load_lanes(boxes.upper_z + first)}};
}
HWY_INLINE Lanes3 set_point(const Vec3& p) {
    return {set(p.x), set(p.y), set(p.z)};
}

HWY_INLINE Bounds hull_of(const Boxes& boxes) {
    BoxLanes all = load_boxes(boxes, 0);
    for (std::uint32_t first = part_lanes; first < 16; first += part_lanes)
        all = join(all, load_boxes(boxes, first));
    return hull_of_lanes(all);
}

HWY_INLINE BoxLanes box_of(const Boxes& boxes, std::uint32_t k) {
    return {set_point({boxes.lower_x[k], boxes.lower_y[k], boxes.lower_z[k]}),
            set_point({boxes.upper_x[k], boxes.upper_y[k], boxes.upper_z[k]})};
}

/// Distance of two boxes along the axis where it is largest. Rounding keeps order: the computed distance of
/// two points in them along that axis is no smaller.
HWY_INLINE Lanes gap(const BoxLanes& a, const BoxLanes& b) {
    const Lanes3 apart = maximum(a.lower - b.upper, b.lower - a.upper);
    return hn::Max(apart.x, hn::Max(apart.y, apart.z));
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
