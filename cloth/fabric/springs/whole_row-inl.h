// A row of W x from the sum over its springs. Included as cloth/equation/sparse/stencil-inl.h is.

#if defined(WEFT_CLOTH_FABRIC_SPRINGS_WHOLE_ROW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_CLOTH_FABRIC_SPRINGS_WHOLE_ROW_INL_H
#undef WEFT_CLOTH_FABRIC_SPRINGS_WHOLE_ROW_INL_H
#else
#define WEFT_CLOTH_FABRIC_SPRINGS_WHOLE_ROW_INL_H
#endif

#include "cloth/equation/external_row-inl.h"
#include "cloth/fabric/springs/spring_matrix.h"
#include "engine/simd/symmetric3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// (W x)_i for the lanes from particle `i` on. `springs` is sum_j A_ij (x_i - x_j) in square units.
HWY_INLINE Lanes3 whole_row(const SpringMatrix& matrix, std::uint32_t i, const Lanes3& x_i,
                            const Lanes3& springs) {
    const Lanes row_sum = load_lanes(&matrix.row_sums[i]);
    Lanes3 own = row_sum * x_i;
    if (touches(matrix.contacts, i)) own = own + contact_blocks(*matrix.contacts, i) * x_i;
    return keep_where(hn::Ne(row_sum, set(0)), mul_add(set(matrix.unit * matrix.unit), springs, own));
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
