#include "cloth/methods/finite_elements/triangle_matrix.h"

#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/methods/finite_elements/triangle_matrix.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/equation/external_row-inl.h"
#include "cloth/equation/row_loops-inl.h"
#include "cloth/equation/sparse/stencil-inl.h"
#include "engine/simd/symmetric3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// sum_j a_ij (x_i - x_j) for the lanes from particle `i` on.
HWY_INLINE Lanes3 scalar_product(const TriangleMatrix& matrix, std::uint32_t i, const RowsInMemory& x,
                                 const Lanes3& x_i) {
    const Stencil& stencil = matrix.scalar_stencil;
    const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
    Lanes3 sum = zero3();
    for (std::uint32_t s = stencil.group_slots[group]; s < stencil.group_slots[group + 1]; ++s)
        sum = mul_add(load_lanes(&matrix.scalars[s * Stencil::lanes + lane]),
                      x_i - neighbour_rows(stencil, s, lane, x.rows), sum);
    return sum;
}

}  // namespace

// The row loops find these by argument-dependent lookup, so they are not in the anonymous namespace.
/// (W x)_i for the lanes from particle `i` on.
HWY_INLINE Lanes3 row_product(const TriangleMatrix& matrix, std::uint32_t i, const RowsInMemory& x,
                              const Lanes3& x_i) {
    const Stencil& stencil = matrix.stencil;
    const Lanes row_sum = load_lanes(&matrix.row_sums[i]);
    Lanes3 sum = row_sum * x_i;
    if (touches(matrix.contacts, i)) sum = sum + contact_blocks(*matrix.contacts, i) * x_i;
    const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
    for (std::uint32_t s = stencil.group_slots[group]; s < stencil.group_slots[group + 1]; ++s) {
        const float* slot = &matrix.blocks[std::size_t{s} * 9 * Stencil::lanes + lane];
        const auto row = [=](std::uint32_t k) HWY_ATTR {
            return Lanes3{load_lanes(slot + 3 * k * Stencil::lanes),
                          load_lanes(slot + (3 * k + 1) * Stencil::lanes),
                          load_lanes(slot + (3 * k + 2) * Stencil::lanes)};
        };
        const Lanes3 difference = x_i - x.neighbours(s, lane);
        sum.x = hn::Add(sum.x, dot(row(0), difference));
        sum.y = hn::Add(sum.y, dot(row(1), difference));
        sum.z = hn::Add(sum.z, dot(row(2), difference));
    }
    if (matrix.scale != 0)
        sum = mul_add(hn::Set(Tag(), matrix.scale), scalar_product(matrix, i, x, x_i), sum);
    return keep_where(hn::Ne(row_sum, hn::Zero(Tag())), sum);
}

/// D_i^-1 v for the lanes from particle `i` on.
HWY_INLINE Lanes3 preconditioned(const TriangleMatrix& matrix, std::uint32_t i, const Lanes3& v) {
    return load_symmetric(&matrix.inverse_diagonal[lane_index(i, 0, 6)]) * v;
}

namespace {

Products multiply(const TriangleMatrix& matrix, const BlockRange& range, const DottedWith& with,
                  const Vec4* x, Vec4* product) {
    RowsInMemory rows{matrix.stencil, x};
    return multiply_rows(matrix, range, with, rows, product);
}

void subtract_product(const TriangleMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                      Vec4* remainder) {
    RowsInMemory rows{matrix.stencil, x};
    subtract_product_rows(matrix, range, b, rows, remainder);
}

void relax(const TriangleMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
           const Relaxation& relaxation, Vec4* next) {
    RowsInMemory rows{matrix.stencil, x};
    relax_rows(matrix, range, b, rows, relaxation, next);
}

void precondition(const TriangleMatrix& matrix, const BlockRange& range, const Vec4* b, float step, Vec4* x) {
    precondition_rows(matrix, range, b, step, x);
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // code that does not depend on the machine
namespace weft {

HWY_EXPORT(multiply);
HWY_EXPORT(subtract_product);
HWY_EXPORT(relax);
HWY_EXPORT(precondition);

void TriangleMatrix::lay_out(Scratch& scratch) {
    scratch.take(blocks, 9 * stencil.neighbours.size());
    scratch.take(row_sums, stencil.nodes);
    scratch.take(inverse_diagonal, std::size_t{6} * stencil.groups() * Stencil::lanes);
}

Products multiply_block(const TriangleMatrix& matrix, const BlockRange& range, const DottedWith& with,
                        const Vec4* x, Vec4* product) {
    return HWY_DYNAMIC_DISPATCH(multiply)(matrix, range, with, x, product);
}

void subtract_product_block(const TriangleMatrix& matrix, const BlockRange& range, const Vec4* b,
                            const Vec4* x, Vec4* remainder) {
    HWY_DYNAMIC_DISPATCH(subtract_product)(matrix, range, b, x, remainder);
}

void relax_block(const TriangleMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                 Relaxation relaxation, Vec4* next) {
    HWY_DYNAMIC_DISPATCH(relax)(matrix, range, b, x, relaxation, next);
}

void precondition_block(const TriangleMatrix& matrix, const BlockRange& range, const Vec4* b, float step,
                        Vec4* x) {
    HWY_DYNAMIC_DISPATCH(precondition)(matrix, range, b, step, x);
}

}  // namespace weft
#endif
