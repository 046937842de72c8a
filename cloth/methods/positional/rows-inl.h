// Vec4 rows that are fetched, changed and put back: for constraints that move their particles. Included like
// cloth/equation/sparse/stencil-inl.h, on which it builds.

#if defined(WEFT_CLOTH_METHODS_POSITIONAL_ROWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_CLOTH_METHODS_POSITIONAL_ROWS_INL_H
#undef WEFT_CLOTH_METHODS_POSITIONAL_ROWS_INL_H
#else
#define WEFT_CLOTH_METHODS_POSITIONAL_ROWS_INL_H
#endif

#include "cloth/equation/sparse/stencil-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

HWY_INLINE Rows operator-(const Rows& a, const Rows& b) {
    return {hn::Sub(a.r0, b.r0), hn::Sub(a.r1, b.r1), hn::Sub(a.r2, b.r2), hn::Sub(a.r3, b.r3)};
}
HWY_INLINE Rows operator+(const Rows& a, const Rows& b) {
    return {hn::Add(a.r0, b.r0), hn::Add(a.r1, b.r1), hn::Add(a.r2, b.r2), hn::Add(a.r3, b.r3)};
}
/// Row i times lane i of s, plus row i of b.
HWY_INLINE Rows mul_add(Lanes s, const Rows& a, const Rows& b) {
    return {hn::MulAdd(hn::Broadcast<0>(s), a.r0, b.r0), hn::MulAdd(hn::Broadcast<1>(s), a.r1, b.r1),
            hn::MulAdd(hn::Broadcast<2>(s), a.r2, b.r2), hn::MulAdd(hn::Broadcast<3>(s), a.r3, b.r3)};
}

template <class D>
HWY_INLINE void put_every_fourth(D d, hn::Vec<D> v, const std::uint32_t* nodes, Vec4* rows) {
    if constexpr (hn::MaxLanes(D()) == 4) {
        hn::Store(v, d, &rows[*nodes].x);
    } else {
        const hn::Half<D> half;
        put_every_fourth(half, hn::LowerHalf(half, v), nodes, rows);
        put_every_fourth(half, hn::UpperHalf(half, v), nodes + hn::MaxLanes(half), rows);
    }
}
HWY_INLINE void put(const Rows& values, const std::uint32_t* nodes, Vec4* rows) {
    const Tag d;
    put_every_fourth(d, values.r0, nodes, rows);
    put_every_fourth(d, values.r1, nodes + 1, rows);
    put_every_fourth(d, values.r2, nodes + 2, rows);
    put_every_fourth(d, values.r3, nodes + 3, rows);
}

/// Lane i to row i, w 0: the inverse of lanes_of.
HWY_INLINE Rows rows_of(const Lanes3& v) {
    const Tag d;
    const hn::Repartition<std::uint64_t, Tag> pairs;
    const Lanes zero = hn::Zero(d);
    const auto xy01 = hn::BitCast(pairs, hn::InterleaveLower(d, v.x, v.y));  // x0 y0 | x1 y1
    const auto xy23 = hn::BitCast(pairs, hn::InterleaveUpper(d, v.x, v.y));
    const auto z01 = hn::BitCast(pairs, hn::InterleaveLower(d, v.z, zero));  // z0 0 | z1 0
    const auto z23 = hn::BitCast(pairs, hn::InterleaveUpper(d, v.z, zero));
    return {hn::BitCast(d, hn::InterleaveLower(pairs, xy01, z01)),
            hn::BitCast(d, hn::InterleaveUpper(pairs, xy01, z01)),
            hn::BitCast(d, hn::InterleaveLower(pairs, xy23, z23)),
            hn::BitCast(d, hn::InterleaveUpper(pairs, xy23, z23))};
}

/// 1 / |d|, or 0 where two particles lie at one point.
HWY_INLINE Lanes inverse_length(Lanes squared) {
    const Tag d;
    const auto apart = hn::Gt(squared, hn::Set(d, coincident));
    return hn::IfThenElseZero(apart, hn::Div(hn::Set(d, 1.0f), hn::Sqrt(squared)));
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
