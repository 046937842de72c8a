// Vec4 rows in registers: x, y and z of many particles, lane by lane. For kernels that Highway compiles once
// for each kind of machine: included by them after hwy/highway.h, once a target, as the guard says.

#if defined(WEFT_ENGINE_SIMD_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_ENGINE_SIMD_LANES_INL_H
#undef WEFT_ENGINE_SIMD_LANES_INL_H
#else
#define WEFT_ENGINE_SIMD_LANES_INL_H
#endif

#include <cstdint>
#include <cstring>

#include "weft/types.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A group of 16 is worked on in parts of as many lanes as a register has: 16, 8 or 4. What a lane computes
/// does not depend on how many there are.
inline constexpr std::uint32_t group_lanes = 16;
using Tag = hn::CappedTag<float, group_lanes>;
using Lanes = hn::Vec<Tag>;
inline constexpr std::uint32_t part_lanes = hn::MaxLanes(Tag());
static_assert(group_lanes % part_lanes == 0 && part_lanes % 4 == 0);

/// A vector of space in each lane.
struct Lanes3 {
    Lanes x, y, z;
};
struct Lanes4 {
    Lanes x, y, z, w;
};

HWY_INLINE Lanes3 xyz(const Lanes4& v) {
    return {v.x, v.y, v.z};
}
HWY_INLINE Lanes3 zero3() {
    return {hn::Zero(Tag()), hn::Zero(Tag()), hn::Zero(Tag())};
}
HWY_INLINE Lanes3 operator+(const Lanes3& a, const Lanes3& b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Lanes3 operator-(const Lanes3& a, const Lanes3& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Lanes3 operator*(Lanes s, const Lanes3& v) {
    return {hn::Mul(s, v.x), hn::Mul(s, v.y), hn::Mul(s, v.z)};
}
/// s v + w, rounded once where the machine can.
HWY_INLINE Lanes3 mul_add(Lanes s, const Lanes3& v, const Lanes3& w) {
    return {hn::MulAdd(s, v.x, w.x), hn::MulAdd(s, v.y, w.y), hn::MulAdd(s, v.z, w.z)};
}
HWY_INLINE Lanes dot(const Lanes3& a, const Lanes3& b) {
    return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x)));
}
template <class Mask>
HWY_INLINE Lanes3 keep_where(Mask mask, const Lanes3& v) {
    return {hn::IfThenElseZero(mask, v.x), hn::IfThenElseZero(mask, v.y), hn::IfThenElseZero(mask, v.z)};
}

template <class Mask>
HWY_INLINE Lanes3 either(Mask mask, const Lanes3& yes, const Lanes3& no) {
    return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
            hn::IfThenElse(mask, yes.z, no.z)};
}
template <class Mask>
HWY_INLINE Lanes4 either(Mask mask, const Lanes4& yes, const Lanes4& no) {
    return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
            hn::IfThenElse(mask, yes.z, no.z), hn::IfThenElse(mask, yes.w, no.w)};
}

HWY_INLINE Lanes3 minimum(const Lanes3& a, const Lanes3& b) {
    return {hn::Min(a.x, b.x), hn::Min(a.y, b.y), hn::Min(a.z, b.z)};
}
HWY_INLINE Lanes3 maximum(const Lanes3& a, const Lanes3& b) {
    return {hn::Max(a.x, b.x), hn::Max(a.y, b.y), hn::Max(a.z, b.z)};
}
/// A bit for each lane, from the lowest on.
template <class D = Tag>
HWY_INLINE std::uint32_t bits_of(hn::Mask<D> mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(D(), mask, bytes);
    std::uint32_t bits;
    std::memcpy(&bits, bytes, sizeof bits);
    return bits;
}
HWY_INLINE Lanes set(float value) {
    return hn::Set(Tag(), value);
}
HWY_INLINE Lanes load_lanes(const float* values) {
    return hn::Load(Tag(), values);
}

/// Consecutive rows, one to a lane.
HWY_INLINE Lanes4 load_rows(const Vec4* rows) {
    const Tag d;
    Lanes4 v;
    if constexpr (part_lanes == 16) {  // across the register: half as many shuffles as within 128 bits
        const float* values = &rows->x;
        const Lanes r0 = hn::LoadU(d, values), r1 = hn::LoadU(d, values + 16);
        const Lanes r2 = hn::LoadU(d, values + 32), r3 = hn::LoadU(d, values + 48);
        const Lanes xz01 = hn::ConcatEven(d, r1, r0), xz23 = hn::ConcatEven(d, r3, r2);  // x0 z0 x1 z1 ..
        const Lanes yw01 = hn::ConcatOdd(d, r1, r0), yw23 = hn::ConcatOdd(d, r3, r2);
        v = {hn::ConcatEven(d, xz23, xz01), hn::ConcatEven(d, yw23, yw01), hn::ConcatOdd(d, xz23, xz01),
             hn::ConcatOdd(d, yw23, yw01)};
    } else {
        hn::LoadInterleaved4(d, &rows->x, v.x, v.y, v.z, v.w);
    }
    return v;
}
HWY_INLINE void store_rows(const Lanes3& v, Lanes w, Vec4* rows) {
    hn::StoreInterleaved4(v.x, v.y, v.z, w, Tag(), &rows->x);
}

using RowTag = hn::FixedTag<float, 4>;
using RowLanes = hn::Vec<RowTag>;

/// row(first), row(first + 4), row(first + 8), .. side by side.
template <class D, class RowAt>
HWY_INLINE hn::Vec<D> every_fourth_row(D d, std::uint32_t first, const RowAt& row) {
    if constexpr (hn::MaxLanes(D()) == 4) {
        return row(first);
    } else {
        const hn::Half<D> half;
        return hn::Combine(
            d, every_fourth_row(half, first + static_cast<std::uint32_t>(hn::MaxLanes(half)), row),
            every_fourth_row(half, first, row));
    }
}

/// As many rows as a register has lanes, one to each 128 bits of four registers: register k holds rows
/// k, k + 4, k + 8, ..
struct Rows {
    Lanes r0, r1, r2, r3;
};

/// Rows row(0), row(1), ..
template <class RowAt>
HWY_INLINE Rows rows_from(const RowAt& row) {
    const Tag d;
    return {every_fourth_row(d, 0, row), every_fourth_row(d, 1, row), every_fourth_row(d, 2, row),
            every_fourth_row(d, 3, row)};
}
/// Rows nodes[0], nodes[1], ..
template <class Number>
HWY_INLINE Rows fetch(const Vec4* rows, const Number* nodes) {
    return rows_from([=](std::uint32_t k) HWY_ATTR { return hn::Load(RowTag(), &rows[nodes[k]].x); });
}

/// Transposes in registers, four by four: row i's x, y, z and w go to lane i.
HWY_INLINE Lanes4 lanes4_of(const Rows& v) {
    const Tag d;
    const hn::Repartition<std::uint64_t, Tag> pairs;
    const auto xy01 = hn::BitCast(pairs, hn::InterleaveLower(d, v.r0, v.r1));  // x0 x1 | y0 y1
    const auto xy23 = hn::BitCast(pairs, hn::InterleaveLower(d, v.r2, v.r3));
    const auto zw01 = hn::BitCast(pairs, hn::InterleaveUpper(d, v.r0, v.r1));  // z0 z1 | w0 w1
    const auto zw23 = hn::BitCast(pairs, hn::InterleaveUpper(d, v.r2, v.r3));
    return {.x = hn::BitCast(d, hn::InterleaveLower(pairs, xy01, xy23)),
            .y = hn::BitCast(d, hn::InterleaveUpper(pairs, xy01, xy23)),
            .z = hn::BitCast(d, hn::InterleaveLower(pairs, zw01, zw23)),
            .w = hn::BitCast(d, hn::InterleaveUpper(pairs, zw01, zw23))};
}
HWY_INLINE Lanes3 lanes_of(const Rows& v) {
    return xyz(lanes4_of(v));
}

/// Rows nodes[0], nodes[1], .., one to a lane. Fetching each whole is twice as fast as gathering x, y and z.
template <class Number>
HWY_INLINE Lanes3 gather_rows(const Vec4* rows, const Number* nodes) {
    return lanes_of(fetch(rows, nodes));
}
template <class Number>
HWY_INLINE Lanes4 gather_rows_with_w(const Vec4* rows, const Number* nodes) {
    return lanes4_of(fetch(rows, nodes));
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
