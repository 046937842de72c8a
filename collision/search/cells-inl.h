// Shared by the searches: lanes of indices, distances, and `Cells` lane by lane. Included as
// engine/simd/lanes-inl.h is.

#if defined(WEFT_COLLISION_SEARCH_CELLS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_COLLISION_SEARCH_CELLS_INL_H
#undef WEFT_COLLISION_SEARCH_CELLS_INL_H
#else
#define WEFT_COLLISION_SEARCH_CELLS_INL_H
#endif

#include "collision/search/cells.h"
#include "engine/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

using IndexTag = hn::Repartition<std::uint32_t, Tag>;
using Indices = hn::Vec<IndexTag>;

/// The squared length as scalar code computes it: no operation is fused. Swapping two points changes only the
/// signs of their difference.
HWY_INLINE Lanes squared_length(const Lanes3& v) {
    return hn::Add(hn::Add(hn::Mul(v.x, v.x), hn::Mul(v.y, v.y)), hn::Mul(v.z, v.z));
}

HWY_INLINE hn::Mask<Tag> is_finite(const Lanes3& p) {
    const Lanes zero = set(0);  // times a value that is not finite: not a number
    return hn::Eq(hn::MulAdd(p.z, zero, hn::MulAdd(p.y, zero, hn::Mul(p.x, zero))), zero);
}

HWY_INLINE Indices set_index(std::uint32_t value) {
    return hn::Set(IndexTag(), value);
}
/// first, first + 1, .. Highway's Iota from a variable stores lane by lane, and waits to load them.
HWY_INLINE Indices indices_from(std::uint32_t first) {
    return hn::Add(set_index(first), hn::Iota(IndexTag(), 0));
}

HWY_INLINE Indices mixed(Indices bits) {
    bits = hn::Mul(hn::Xor(bits, hn::ShiftRight<15>(bits)), set_index(0x2C1B3C6Du));
    return hn::Xor(bits, hn::ShiftRight<13>(bits));
}

/// Cells::at, lane by lane. Not-a-number is not greater than zero, so its cell is 0.
HWY_INLINE Indices cell_at(const Cells& cells, Lanes coordinate, float from) {
    const Lanes offset = hn::Mul(hn::Sub(coordinate, set(from)), set(cells.per_metre));
    const Lanes cell = hn::Add(offset, set(cells.shift));
    const Lanes in_range = hn::IfThenElseZero(hn::Gt(cell, set(0)), hn::Min(cell, set(Cells::limit)));
    return hn::BitCast(IndexTag(), hn::ConvertTo(hn::RebindToSigned<Tag>(), in_range));
}

HWY_INLINE Indices row_bucket(const Cells& cells, const Lanes3& p) {
    const Indices y = hn::ShiftRight<1>(cell_at(cells, p.y, cells.origin.y));
    const Indices z = hn::ShiftRight<1>(cell_at(cells, p.z, cells.origin.z));
    const Indices row =
        mixed(hn::Xor(hn::Mul(y, set_index(CellHash::y)), hn::Mul(z, set_index(CellHash::z))));
    return hn::And(hn::Add(cell_at(cells, p.x, cells.origin.x), row), set_index(cells.mask));
}

HWY_INLINE Indices cube_bucket(const Cells& cells, const Lanes3& p) {
    const Indices x = hn::Mul(cell_at(cells, p.x, cells.origin.x), set_index(CellHash::x));
    const Indices y = hn::Mul(cell_at(cells, p.y, cells.origin.y), set_index(CellHash::y));
    const Indices z = hn::Mul(cell_at(cells, p.z, cells.origin.z), set_index(CellHash::z));
    return hn::And(mixed(hn::Xor(x, mixed(hn::Xor(y, z)))), set_index(cells.mask));
}

struct RunsLanes {
    Indices run[4];
};

/// The factor times the own cell along an axis, and times the neighbour on the side of the half.
struct SideHashes {
    Indices own, other;
};
HWY_INLINE SideHashes side_hashes(Indices half, std::uint32_t factor) {
    const Indices own = hn::Mul(hn::ShiftRight<1>(half), set_index(factor));
    const auto is_upper = hn::Ne(hn::And(half, set_index(1)), set_index(0));
    return {own, hn::Add(own, hn::IfThenElse(is_upper, set_index(factor), set_index(0u - factor)))};
}

HWY_INLINE RunsLanes runs_near(const Cells& cells, const Lanes3& p) {
    const Indices left = hn::Sub(cell_at(cells, p.x, cells.origin.x), set_index(1));
    const SideHashes y = side_hashes(cell_at(cells, p.y, cells.origin.y), CellHash::y);
    const SideHashes z = side_hashes(cell_at(cells, p.z, cells.origin.z), CellHash::z);
    const auto run = [&](Indices hash_y, Indices hash_z) {
        return hn::And(hn::Add(left, mixed(hn::Xor(hash_y, hash_z))), set_index(cells.mask));
    };
    return {{run(y.own, z.own), run(y.other, z.own), run(y.own, z.other), run(y.other, z.other)}};
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
