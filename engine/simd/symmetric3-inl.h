// Symmetric 3x3 blocks lane by lane: symmetric3.h for kernels. Included as lanes-inl.h.

#if defined(WEFT_ENGINE_SIMD_SYMMETRIC3_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_ENGINE_SIMD_SYMMETRIC3_INL_H
#undef WEFT_ENGINE_SIMD_SYMMETRIC3_INL_H
#else
#define WEFT_ENGINE_SIMD_SYMMETRIC3_INL_H
#endif

#include "engine/simd/lanes-inl.h"
#include "engine/simd/symmetric3.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

struct SymmetricLanes {
    Lanes xx, yy, zz, xy, xz, yz;

    HWY_INLINE Lanes3 operator*(const Lanes3& v) const {
        return {dot({xx, xy, xz}, v), dot({xy, yy, yz}, v), dot({xz, yz, zz}, v)};
    }
};

HWY_INLINE SymmetricLanes zero_symmetric() {
    const Lanes zero = hn::Zero(Tag());
    return {zero, zero, zero, zero, zero, zero};
}

/// Stored as six arrays of a group's 16 lanes; `values` points into the first.
HWY_INLINE SymmetricLanes load_symmetric(const float* values) {
    constexpr std::uint32_t next = group_lanes;
    return {load_lanes(values),
            load_lanes(values + next),
            load_lanes(values + 2 * next),
            load_lanes(values + 3 * next),
            load_lanes(values + 4 * next),
            load_lanes(values + 5 * next)};
}
HWY_INLINE void store_symmetric(const SymmetricLanes& m, float* values) {
    const Tag d;
    constexpr std::uint32_t next = group_lanes;
    hn::Store(m.xx, d, values);
    hn::Store(m.yy, d, values + next);
    hn::Store(m.zz, d, values + 2 * next);
    hn::Store(m.xy, d, values + 3 * next);
    hn::Store(m.xz, d, values + 4 * next);
    hn::Store(m.yz, d, values + 5 * next);
}

HWY_INLINE SymmetricLanes operator+(const SymmetricLanes& a, const SymmetricLanes& b) {
    return {hn::Add(a.xx, b.xx), hn::Add(a.yy, b.yy), hn::Add(a.zz, b.zz),
            hn::Add(a.xy, b.xy), hn::Add(a.xz, b.xz), hn::Add(a.yz, b.yz)};
}
/// m + d d^T.
HWY_INLINE SymmetricLanes add_square(const SymmetricLanes& m, const Lanes3& d) {
    return {hn::MulAdd(d.x, d.x, m.xx), hn::MulAdd(d.y, d.y, m.yy), hn::MulAdd(d.z, d.z, m.zz),
            hn::MulAdd(d.x, d.y, m.xy), hn::MulAdd(d.x, d.z, m.xz), hn::MulAdd(d.y, d.z, m.yz)};
}
/// m + a I.
HWY_INLINE SymmetricLanes add_identity(const SymmetricLanes& m, Lanes a) {
    return {hn::Add(m.xx, a), hn::Add(m.yy, a), hn::Add(m.zz, a), m.xy, m.xz, m.yz};
}
HWY_INLINE SymmetricLanes operator*(Lanes s, const SymmetricLanes& m) {
    return {hn::Mul(s, m.xx), hn::Mul(s, m.yy), hn::Mul(s, m.zz),
            hn::Mul(s, m.xy), hn::Mul(s, m.xz), hn::Mul(s, m.yz)};
}
template <class Mask>
HWY_INLINE SymmetricLanes keep_where(Mask mask, const SymmetricLanes& m) {
    return {hn::IfThenElseZero(mask, m.xx), hn::IfThenElseZero(mask, m.yy), hn::IfThenElseZero(mask, m.zz),
            hn::IfThenElseZero(mask, m.xy), hn::IfThenElseZero(mask, m.xz), hn::IfThenElseZero(mask, m.yz)};
}

/// inverse of symmetric3.h, by the same steps.
HWY_INLINE SymmetricLanes inverse(const SymmetricLanes& m, Lanes least) {
    const Tag d;
    const Lanes one = hn::Set(d, 1.0f), rounding = hn::Set(d, inverse_rounding);
    const Lanes floor = hn::Max(least, hn::Mul(rounding, hn::Add(hn::Add(m.xx, m.yy), m.zz)));
    const Lanes lift = hn::Sub(floor, least);

    const Lanes i0 = hn::Div(one, hn::Max(hn::Add(m.xx, lift), floor));
    const Lanes l10 = hn::Mul(m.xy, i0), l20 = hn::Mul(m.xz, i0);
    const Lanes d1 = hn::Max(hn::NegMulAdd(l10, m.xy, hn::Add(m.yy, lift)), floor);
    const Lanes i1 = hn::Div(one, d1);
    const Lanes l21 = hn::Mul(hn::NegMulAdd(l20, m.xy, m.yz), i1);
    const Lanes left = hn::NegMulAdd(l20, m.xz, hn::Add(m.zz, lift));
    const Lanes i2 = hn::Div(one, hn::Max(hn::NegMulAdd(hn::Mul(l21, l21), d1, left), floor));

    const Lanes c20 = hn::MulSub(l10, l21, l20);
    const Lanes c20_i2 = hn::Mul(c20, i2), c21_i2 = hn::Neg(hn::Mul(l21, i2));
    return {.xx = hn::MulAdd(c20, c20_i2, hn::MulAdd(hn::Mul(l10, l10), i1, i0)),
            .yy = hn::NegMulAdd(l21, c21_i2, i1),
            .zz = i2,
            .xy = hn::MulSub(c20, c21_i2, hn::Mul(l10, i1)),
            .xz = c20_i2,
            .yz = c21_i2};
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
