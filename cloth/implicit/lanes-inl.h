// Vec4 rows in registers: x, y and z of many particles, lane by lane. For kernels that Highway compiles once
// for each kind of machine: included by them after hwy/highway.h, once a target, as the guard says.

#if defined(WEFT_CLOTH_IMPLICIT_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_CLOTH_IMPLICIT_LANES_INL_H
#undef WEFT_CLOTH_IMPLICIT_LANES_INL_H
#else
#define WEFT_CLOTH_IMPLICIT_LANES_INL_H
#endif

#include <cstdint>

#include "cloth/implicit/stencil.h"
#include "weft/types.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A group of 16 is worked on in parts of as many lanes as a register has: 16, 8 or 4. What a lane computes
/// does not depend on how many there are.
using Tag = hn::CappedTag<float, Stencil::lanes>;
using Lanes = hn::Vec<Tag>;
inline constexpr std::uint32_t part_lanes = hn::MaxLanes(Tag());
static_assert(Stencil::lanes % part_lanes == 0 && part_lanes % 4 == 0);

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

HWY_INLINE Lanes load_lanes(const float* values) {
    return hn::Load(Tag(), values);
}

/// Consecutive rows, one to a lane.
HWY_INLINE Lanes4 load_rows(const Vec4* rows) {
    Lanes4 v;
    hn::LoadInterleaved4(Tag(), &rows->x, v.x, v.y, v.z, v.w);
    return v;
}
HWY_INLINE void store_rows(const Lanes3& v, Lanes w, Vec4* rows) {
    hn::StoreInterleaved4(v.x, v.y, v.z, w, Tag(), &rows->x);
}

/// Rows nodes[0], nodes[4], nodes[8], .. side by side.
template <class D>
HWY_INLINE hn::Vec<D> every_fourth_row(D d, const Vec4* rows, const std::uint32_t* nodes) {
    if constexpr (hn::MaxLanes(D()) == 4) {
        return hn::Load(d, &rows[*nodes].x);
    } else {
        const hn::Half<D> half;
        return hn::Combine(d, every_fourth_row(half, rows, nodes + hn::MaxLanes(half)),
                           every_fourth_row(half, rows, nodes));
    }
}

/// Rows nodes[0], nodes[1], .., one to a lane: each fetched whole, then transposed in registers, four by
/// four. That is twice as fast as gathering x, y and z.
HWY_INLINE Lanes3 gather_rows(const Vec4* rows, const std::uint32_t* nodes) {
    const Tag d;
    const hn::Repartition<std::uint64_t, Tag> pairs;
    const Lanes r0 = every_fourth_row(d, rows, nodes), r1 = every_fourth_row(d, rows, nodes + 1);
    const Lanes r2 = every_fourth_row(d, rows, nodes + 2), r3 = every_fourth_row(d, rows, nodes + 3);
    const auto xy01 = hn::BitCast(pairs, hn::InterleaveLower(d, r0, r1));  // x0 x1 | y0 y1
    const auto xy23 = hn::BitCast(pairs, hn::InterleaveLower(d, r2, r3));
    const auto zw01 = hn::BitCast(pairs, hn::InterleaveUpper(d, r0, r1));  // z0 z1 | w0 w1
    const auto zw23 = hn::BitCast(pairs, hn::InterleaveUpper(d, r2, r3));
    return {.x = hn::BitCast(d, hn::InterleaveLower(pairs, xy01, xy23)),
            .y = hn::BitCast(d, hn::InterleaveUpper(pairs, xy01, xy23)),
            .z = hn::BitCast(d, hn::InterleaveLower(pairs, zw01, zw23))};
}

/// Of a part of slot s, which begins at `lane`, the neighbours' rows.
HWY_INLINE Lanes3 neighbour_rows(const Stencil& stencil, std::uint32_t s, std::uint32_t lane,
                                 const Vec4* rows) {
    const std::uint32_t first = stencil.runs[s];
    return first != Stencil::no_run ? xyz(load_rows(rows + first + lane))
                                    : gather_rows(rows, &stencil.neighbours[s * Stencil::lanes + lane]);
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
