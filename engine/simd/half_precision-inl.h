// Half precision in memory, single in registers. Included as cloth/equation/sparse/stencil-inl.h.

#if defined(WEFT_ENGINE_SIMD_HALF_PRECISION_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_ENGINE_SIMD_HALF_PRECISION_INL_H
#undef WEFT_ENGINE_SIMD_HALF_PRECISION_INL_H
#else
#define WEFT_ENGINE_SIMD_HALF_PRECISION_INL_H
#endif

#include "engine/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

using HalfTag = hn::Rebind<hwy::float16_t, Tag>;
using HalfBits = hn::Rebind<std::uint16_t, Tag>;

HWY_INLINE Lanes load_halves(const std::uint16_t* values) {
    return hn::PromoteTo(Tag(), hn::BitCast(HalfTag(), hn::Load(HalfBits(), values)));
}
/// Stores values as halves and returns the values that a load will give back. They are truncated to eleven
/// binary digits, not rounded: one instruction in place of two, in the loop that linearises.
HWY_INLINE Lanes store_halves(Lanes v, std::uint16_t* values) {
    const hn::RebindToUnsigned<Tag> bits;
    const Lanes cut = hn::BitCast(Tag(), hn::And(hn::BitCast(bits, v), hn::Set(bits, 0xFFFFE000u)));
    hn::Store(hn::BitCast(HalfBits(), hn::DemoteTo(HalfTag(), cut)), HalfBits(), values);
    return cut;
}

/// A block a I + d d^T in each lane.
struct SpringBlockLanes {
    Lanes a;
    Lanes3 d;
};
/// Stored as four arrays of a slot's 16 lanes; `values` points into the first.
HWY_INLINE SpringBlockLanes load_block(const std::uint16_t* values) {
    constexpr std::uint32_t next = group_lanes;
    return {load_halves(values),
            {load_halves(values + next), load_halves(values + 2 * next), load_halves(values + 3 * next)}};
}
HWY_INLINE SpringBlockLanes store_block(const SpringBlockLanes& block, std::uint16_t* values) {
    constexpr std::uint32_t next = group_lanes;
    return {store_halves(block.a, values),
            {store_halves(block.d.x, values + next), store_halves(block.d.y, values + 2 * next),
             store_halves(block.d.z, values + 3 * next)}};
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
