// Vec4 rows in registers as they lie in memory, for kernels that are mostly sums of rows: sums need no
// transposing. Included like cloth/equation/sparse/stencil-inl.h, on which it builds.

#if defined(WEFT_ENGINE_SIMD_PACKED_ROWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_ENGINE_SIMD_PACKED_ROWS_INL_H
#undef WEFT_ENGINE_SIMD_PACKED_ROWS_INL_H
#else
#define WEFT_ENGINE_SIMD_PACKED_ROWS_INL_H
#endif

#include <cstring>

#include "engine/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// As many rows as a register has lanes, in four registers, one after the other.
struct PackedRows {
    Lanes r0, r1, r2, r3;
};

HWY_INLINE PackedRows operator+(const PackedRows& a, const PackedRows& b) {
    return {hn::Add(a.r0, b.r0), hn::Add(a.r1, b.r1), hn::Add(a.r2, b.r2), hn::Add(a.r3, b.r3)};
}
HWY_INLINE PackedRows operator-(const PackedRows& a, const PackedRows& b) {
    return {hn::Sub(a.r0, b.r0), hn::Sub(a.r1, b.r1), hn::Sub(a.r2, b.r2), hn::Sub(a.r3, b.r3)};
}
HWY_INLINE PackedRows operator*(Lanes s, const PackedRows& v) {
    return {hn::Mul(s, v.r0), hn::Mul(s, v.r1), hn::Mul(s, v.r2), hn::Mul(s, v.r3)};
}
/// s v + w.
HWY_INLINE PackedRows mul_add(Lanes s, const PackedRows& v, const PackedRows& w) {
    return {hn::MulAdd(s, v.r0, w.r0), hn::MulAdd(s, v.r1, w.r1), hn::MulAdd(s, v.r2, w.r2),
            hn::MulAdd(s, v.r3, w.r3)};
}

/// Consecutive rows.
HWY_INLINE PackedRows load_packed(const Vec4* rows) {
    const Tag d;
    const float* values = &rows->x;
    return {hn::LoadU(d, values), hn::LoadU(d, values + part_lanes), hn::LoadU(d, values + 2 * part_lanes),
            hn::LoadU(d, values + 3 * part_lanes)};
}
HWY_INLINE void store_packed(const PackedRows& v, Vec4* rows) {
    const Tag d;
    float* values = &rows->x;
    hn::StoreU(v.r0, d, values);
    hn::StoreU(v.r1, d, values + part_lanes);
    hn::StoreU(v.r2, d, values + 2 * part_lanes);
    hn::StoreU(v.r3, d, values + 3 * part_lanes);
}

HWY_INLINE const float* row_at(const Vec4* rows, std::uint64_t offset) {
    return reinterpret_cast<const float*>(reinterpret_cast<const char*>(rows) + offset);
}
/// The rows at offsets[0], offsets[1], .. [bytes], side by side in one register. Offsets are read two at a
/// time, because the number of loads is what limits a gather.
template <class D>
HWY_INLINE hn::Vec<D> rows_side_by_side(D d, const Vec4* rows, const std::uint32_t* offsets) {
    if constexpr (hn::MaxLanes(D()) == 4) {
        return hn::Load(d, row_at(rows, *offsets));
    } else if constexpr (hn::MaxLanes(D()) == 8) {
        const hn::Half<D> half;
        std::uint64_t two;
        std::memcpy(&two, offsets, sizeof two);
        return hn::Combine(d, hn::Load(half, row_at(rows, two >> 32)),
                           hn::Load(half, row_at(rows, static_cast<std::uint32_t>(two))));
    } else {
        const hn::Half<D> half;
        return hn::Combine(d, rows_side_by_side(half, rows, offsets + hn::MaxLanes(half) / 4),
                           rows_side_by_side(half, rows, offsets));
    }
}
/// The rows at offsets[0], offsets[1], .. [bytes].
HWY_INLINE PackedRows gather_packed(const Vec4* rows, const std::uint32_t* offsets) {
    const Tag d;
    constexpr std::uint32_t quarter = part_lanes / 4;
    return {rows_side_by_side(d, rows, offsets), rows_side_by_side(d, rows, offsets + quarter),
            rows_side_by_side(d, rows, offsets + 2 * quarter),
            rows_side_by_side(d, rows, offsets + 3 * quarter)};
}

/// Transposes to one row a lane. The order of lanes is not that of the rows, but the same in all registers;
/// packed() undoes it.
HWY_INLINE Lanes3 unpacked(const PackedRows& v) {
    return lanes_of(Rows{v.r0, v.r1, v.r2, v.r3});
}
HWY_INLINE PackedRows packed(const Lanes3& v, Lanes w) {
    const Tag d;
    const hn::Repartition<std::uint64_t, Tag> pairs;
    const auto xy01 = hn::BitCast(pairs, hn::InterleaveLower(d, v.x, v.y));  // x0 y0 | x1 y1
    const auto xy23 = hn::BitCast(pairs, hn::InterleaveUpper(d, v.x, v.y));
    const auto zw01 = hn::BitCast(pairs, hn::InterleaveLower(d, v.z, w));
    const auto zw23 = hn::BitCast(pairs, hn::InterleaveUpper(d, v.z, w));
    return {hn::BitCast(d, hn::InterleaveLower(pairs, xy01, zw01)),
            hn::BitCast(d, hn::InterleaveUpper(pairs, xy01, zw01)),
            hn::BitCast(d, hn::InterleaveLower(pairs, xy23, zw23)),
            hn::BitCast(d, hn::InterleaveUpper(pairs, xy23, zw23))};
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
