// BlockLanes in registers. Included as engine/simd/lanes-inl.h is.

#if defined(WEFT_COLLISION_COLLIDERS_BLOCK_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_COLLISION_COLLIDERS_BLOCK_LANES_INL_H
#undef WEFT_COLLISION_COLLIDERS_BLOCK_LANES_INL_H
#else
#define WEFT_COLLISION_COLLIDERS_BLOCK_LANES_INL_H
#endif

#include "collision/colliders/collider_contacts.h"
#include "engine/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// Loads and stores a block's particles from `i` on.
HWY_INLINE Lanes4 load_lanes(const BlockLanes& lanes, std::uint32_t i) {
    return {load_lanes(&lanes.x[i]), load_lanes(&lanes.y[i]), load_lanes(&lanes.z[i]),
            load_lanes(&lanes.w[i])};
}
HWY_INLINE void store_lanes(const Lanes4& v, BlockLanes& lanes, std::uint32_t i) {
    const Tag d;
    hn::Store(v.x, d, &lanes.x[i]);
    hn::Store(v.y, d, &lanes.y[i]);
    hn::Store(v.z, d, &lanes.z[i]);
    hn::Store(v.w, d, &lanes.w[i]);
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
