// The loops over a matrix's rows that solvers are made of, once for every kind of matrix. For the lanes from
// row i on, a matrix has row_product(matrix, i, x, x_i), which is (W x)_i, and preconditioned(matrix, i, v),
// which is D_i^-1 v. Included as cloth/implicit/lanes-inl.h.

#if defined(WEFT_CLOTH_IMPLICIT_ROW_LOOPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_CLOTH_IMPLICIT_ROW_LOOPS_INL_H
#undef WEFT_CLOTH_IMPLICIT_ROW_LOOPS_INL_H
#else
#define WEFT_CLOTH_IMPLICIT_ROW_LOOPS_INL_H
#endif

#include <numeric>

#include "cloth/implicit/implicit_system.h"
#include "cloth/implicit/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// product = W x, unless it is null. Returns the rows' share of x . W x.
template <class Matrix>
double multiply_rows(const Matrix& matrix, const BlockRange& range, const Vec4* x, Vec4* product) {
    alignas(64) float dots[Stencil::lanes] = {};  // by lane, so that the sum is the same at any width
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const Lanes3 x_i = xyz(load_rows(x + i));
        const Lanes3 row = row_product(matrix, i, x, x_i);
        if (product != nullptr) store_rows(row, hn::Zero(Tag()), product + i);
        float* const partial = dots + i % Stencil::lanes;
        hn::Store(hn::Add(load_lanes(partial), dot(row, x_i)), Tag(), partial);
    }
    return std::accumulate(std::begin(dots), std::end(dots), 0.0);
}

/// remainder = b - W x.
template <class Matrix>
void subtract_product_rows(const Matrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                           Vec4* remainder) {
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const Lanes3 row = row_product(matrix, i, x, xyz(load_rows(x + i)));
        store_rows(xyz(load_rows(b + i)) - row, hn::Zero(Tag()), remainder + i);
    }
}

/// See Relaxation.
template <class Matrix>
void relax_rows(const Matrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                const Relaxation& relaxation, Vec4* next) {
    const Lanes step = hn::Set(Tag(), relaxation.step), momentum = hn::Set(Tag(), relaxation.momentum);
    const bool has_momentum = relaxation.momentum != 0;  // else `next` may hold anything
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const Lanes3 x_i = xyz(load_rows(x + i));
        const Lanes3 residual = xyz(load_rows(b + i)) - row_product(matrix, i, x, x_i);
        const Lanes3 moved = has_momentum ? mul_add(momentum, x_i - xyz(load_rows(next + i)), x_i) : x_i;
        store_rows(mul_add(step, preconditioned(matrix, i, residual), moved), hn::Zero(Tag()), next + i);
    }
}

/// x = step D^-1 b.
template <class Matrix>
void precondition_rows(const Matrix& matrix, const BlockRange& range, const Vec4* b, float step, Vec4* x) {
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const Lanes3 v = preconditioned(matrix, i, xyz(load_rows(b + i)));
        store_rows(hn::Set(Tag(), step) * v, hn::Zero(Tag()), x + i);
    }
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
