#include "engine/simd/symmetric3.h"

#include <algorithm>

namespace weft {

// L D L^T factorisation. Every pivot of a matrix is at least its least eigenvalue, so a pivot that rounding
// has brought below is lifted.
Symmetric3 inverse(const Symmetric3& m, float least) {
    const float floor = std::max(least, inverse_rounding * (m.xx + m.yy + m.zz));
    const float lift = floor - least;

    const float d0 = std::max(m.xx + lift, floor);
    const float l10 = m.xy / d0;
    const float l20 = m.xz / d0;
    const float d1 = std::max(m.yy + lift - l10 * m.xy, floor);
    const float l21 = (m.yz - l20 * m.xy) / d1;
    const float d2 = std::max(m.zz + lift - l20 * m.xz - l21 * l21 * d1, floor);

    // M^-1 = sum_k c_k c_k^T / d_k, c_k being the columns of L^-T.
    const float i0 = 1.0f / d0, i1 = 1.0f / d1, i2 = 1.0f / d2;
    const float c10 = -l10;
    const float c20 = l10 * l21 - l20;
    const float c21 = -l21;
    return {.xx = i0 + c10 * c10 * i1 + c20 * c20 * i2,
            .yy = i1 + c21 * c21 * i2,
            .zz = i2,
            .xy = c10 * i1 + c20 * c21 * i2,
            .xz = c20 * i2,
            .yz = c21 * i2};
}

}  // namespace weft
