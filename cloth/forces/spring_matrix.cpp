#include "cloth/forces/spring_matrix.h"

#include <cmath>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/forces/spring_matrix.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/forces/halves-inl.h"
#include "cloth/implicit/external_row-inl.h"
#include "cloth/implicit/lanes-inl.h"
#include "cloth/implicit/row_loops-inl.h"
#include "cloth/implicit/symmetric3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
// Found by the loops through their vectors' namespace, so not in the file's own.
/// (W x)_i for the lanes from particle `i` on.
template <class Rows>
HWY_INLINE Lanes3 row_product(const SpringMatrix& matrix, std::uint32_t i, const Rows& x, const Lanes3& x_i) {
    const Stencil& stencil = matrix.stencil;
    const Lanes zero = hn::Zero(Tag());
    Lanes3 sum = {zero, zero, zero};
    const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
    for (std::uint32_t s = stencil.group_slots[group]; s < stencil.group_slots[group + 1]; ++s) {
        const auto [a, d] = load_block(&matrix.coefficients[lane_index(s * Stencil::lanes + lane, 0, 4)]);
        const Lanes3 difference = x_i - x.neighbours(s, lane);
        sum = mul_add(dot(d, difference), d, mul_add(a, difference, sum));
    }
    const Lanes row_sum = load_lanes(&matrix.row_sums[i]);
    const Lanes squared_unit = hn::Set(Tag(), matrix.unit * matrix.unit);
    Lanes3 own = row_sum * x_i;
    if (touches(matrix.contacts, i)) own = own + contact_blocks(*matrix.contacts, i) * x_i;
    return keep_where(hn::Ne(row_sum, zero), mul_add(squared_unit, sum, own));
}

/// D_i^-1 v for the lanes from particle `i` on.
HWY_INLINE Lanes3 preconditioned(const SpringMatrix& matrix, std::uint32_t i, const Lanes3& v) {
    return load_symmetric(&matrix.inverse_diagonal[lane_index(i, 0, 6)]) * v;
}

namespace {

/// loop(rows), with x in rows from memory or from the window, if there is one.
template <class Loop>
HWY_INLINE auto with_rows(const SpringMatrix& matrix, const BlockRange& range, const Vec4* x,
                          RowWindow* window, const Loop& loop) {
    if (window == nullptr) {
        RowsInMemory rows{matrix.stencil, x};
        return loop(rows);
    }
    RowsInWindow rows(*window, matrix.stencil, range, x);
    return loop(rows);
}

Products multiply(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                  Vec4* product, RowWindow* window) {
    return with_rows(matrix, range, x, window,
                     [&](auto& rows) HWY_ATTR { return multiply_rows(matrix, range, b, rows, product); });
}

void subtract_product(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                      Vec4* remainder, RowWindow* window) {
    with_rows(matrix, range, x, window,
              [&](auto& rows) HWY_ATTR { subtract_product_rows(matrix, range, b, rows, remainder); });
}

void relax(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
           const Relaxation& relaxation, Vec4* next, RowWindow* window) {
    with_rows(matrix, range, x, window,
              [&](auto& rows) HWY_ATTR { relax_rows(matrix, range, b, rows, relaxation, next); });
}

void precondition(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, float step, Vec4* x) {
    precondition_rows(matrix, range, b, step, x);
}

void unpack(const SpringMatrix& matrix, const BlockRange& range, const std::uint32_t* slots, Vec4* blocks) {
    const Lanes unit = hn::Set(Tag(), matrix.unit), squared_unit = hn::Mul(unit, unit);
    for (std::uint32_t k = range.begin; k < range.end; ++k) {
        for (std::uint32_t lane = 0; lane < Stencil::lanes; lane += part_lanes) {
            const std::size_t at = lane_index(slots[k] * Stencil::lanes + lane, 0, 4);
            const auto [a, d] = load_block(&matrix.coefficients[at]);
            store_rows(unit * d, hn::Mul(squared_unit, a), blocks + k * Stencil::lanes + lane);
        }
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // what does not depend on the machine
namespace weft {

HWY_EXPORT(multiply);
HWY_EXPORT(subtract_product);
HWY_EXPORT(relax);
HWY_EXPORT(precondition);
HWY_EXPORT(unpack);

SpringMatrix::SpringMatrix(Stencil neighbours)
    : stencil(std::move(neighbours)),
      coefficients(4 * stencil.neighbours.size()),
      row_sums(stencil.nodes),
      inverse_diagonal(std::size_t{6} * stencil.groups() * Stencil::lanes) {}

// Halves reach from 2^-14 (2^-24 with fewer digits) to 2^16. With |d| of at most 2^7 units, a is at most 2^14
// square units, and the softest spring that keeps its digits is 2^28 times softer than the stiffest.
void SpringMatrix::set_unit(float largest_block) {
    int exponent = 0;
    std::frexp(std::sqrt(largest_block), &exponent);
    unit = largest_block > 0 ? std::ldexp(1.0f, exponent - 7) : 1.0f;
}

Products multiply_block(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                        Vec4* product, RowWindow* window) {
    return HWY_DYNAMIC_DISPATCH(multiply)(matrix, range, b, x, product, window);
}

void subtract_product_block(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                            Vec4* remainder, RowWindow* window) {
    HWY_DYNAMIC_DISPATCH(subtract_product)(matrix, range, b, x, remainder, window);
}

void relax_block(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                 Relaxation relaxation, Vec4* next, RowWindow* window) {
    HWY_DYNAMIC_DISPATCH(relax)(matrix, range, b, x, relaxation, next, window);
}

void precondition_block(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, float step,
                        Vec4* x) {
    HWY_DYNAMIC_DISPATCH(precondition)(matrix, range, b, step, x);
}

void unpack_block(const SpringMatrix& matrix, const BlockRange& range, const std::uint32_t* slots,
                  Vec4* blocks) {
    HWY_DYNAMIC_DISPATCH(unpack)(matrix, range, slots, blocks);
}

}  // namespace weft
#endif
