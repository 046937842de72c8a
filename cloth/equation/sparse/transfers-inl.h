// A coarse correction in registers. Included as cloth/equation/sparse/stencil-inl.h.

#if defined(WEFT_CLOTH_EQUATION_SPARSE_TRANSFERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_CLOTH_EQUATION_SPARSE_TRANSFERS_INL_H
#undef WEFT_CLOTH_EQUATION_SPARSE_TRANSFERS_INL_H
#else
#define WEFT_CLOTH_EQUATION_SPARSE_TRANSFERS_INL_H
#endif

#include "cloth/equation/sparse/transfers.h"
#include "engine/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// weight times a row, added to a sum.
HWY_INLINE RowLanes add_weighted(float weight, const Vec4& row, RowLanes sum) {
    return hn::MulAdd(hn::Set(RowTag(), weight), hn::Load(RowTag(), &row.x), sum);
}

/// x + (P e)_i.
HWY_INLINE RowLanes corrected(const Correction& correction, std::uint32_t i, RowLanes x) {
    static_assert(Interpolation::width == 3);
    const std::uint32_t row = correction.first + i;
    if (correction.pinned != nullptr && correction.pinned[row] != 0) return x;
    const std::uint32_t* const nodes = &correction.p.nodes[Interpolation::width * row];
    const float* const weights = &correction.p.weights[Interpolation::width * row];
    const Vec4* const coarse = correction.coarse.data();
    x = add_weighted(weights[0], coarse[nodes[0]], x);
    x = add_weighted(weights[1], coarse[nodes[1]], x);
    return add_weighted(weights[2], coarse[nodes[2]], x);
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
