// The loops over the rows of a matrix that solvers are made of, written once for all matrices. A matrix
// brings two functions for the lanes from row i on: row_product(matrix, i, x, x_i), which is (W x)_i for x in
// RowsInMemory or in a grid's window, and preconditioned(matrix, i, v), which is D_i^-1 v. All of it is
// inlined, because GridLoop needs that. Included as cloth/equation/sparse/stencil-inl.h.

#if defined(WEFT_CLOTH_EQUATION_ROW_LOOPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_CLOTH_EQUATION_ROW_LOOPS_INL_H
#undef WEFT_CLOTH_EQUATION_ROW_LOOPS_INL_H
#else
#define WEFT_CLOTH_EQUATION_ROW_LOOPS_INL_H
#endif

#include <numeric>

#include "cloth/equation/implicit_system.h"
#include "cloth/equation/sparse/stencil-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// The sums over a block's rows, one for each of 16 lanes, so that they are the same at any vector width.
class SumByLanes {
  public:
    HWY_INLINE void add(std::uint32_t lane, Lanes values) {
        hn::Store(hn::Add(load_lanes(sums_ + lane), values), Tag(), sums_ + lane);
    }
    [[nodiscard]] double all() const { return std::accumulate(std::begin(sums_), std::end(sums_), 0.0); }

  private:
    alignas(64) float sums_[Stencil::lanes] = {};
};

/// product = W x, unless `product` is null. Returns the rows' shares.
template <class Matrix, class Rows>
HWY_INLINE Products multiply_rows(const Matrix& matrix, const BlockRange& range, const DottedWith& with,
                                  Rows& x, Vec4* product) {
    SumByLanes dots[3], x_wx;
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        x.come_to(i);
        const Lanes3 x_i = x.own(i);
        const Lanes3 row = row_product(matrix, i, x, x_i);
        if (product != nullptr) store_rows(row, hn::Zero(Tag()), product + i);
        const std::uint32_t lane = i % Stencil::lanes;
        for (std::size_t k = 0; k < with.size(); ++k)
            if (with[k] != nullptr) dots[k].add(lane, dot(xyz(load_rows(with[k] + i)), x_i));
        x_wx.add(lane, dot(row, x_i));
    }
    return {{dots[0].all(), dots[1].all(), dots[2].all()}, x_wx.all()};
}

/// remainder = b - W x.
template <class Matrix, class Rows>
HWY_INLINE void subtract_product_rows(const Matrix& matrix, const BlockRange& range, const Vec4* b, Rows& x,
                                      Vec4* remainder) {
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        x.come_to(i);
        const Lanes3 row = row_product(matrix, i, x, x.own(i));
        store_rows(xyz(load_rows(b + i)) - row, hn::Zero(Tag()), remainder + i);
    }
}

/// See Relaxation.
template <class Matrix, class Rows>
HWY_INLINE void relax_rows(const Matrix& matrix, const BlockRange& range, const Vec4* b, Rows& x,
                           const Relaxation& relaxation, Vec4* next) {
    const Lanes step = hn::Set(Tag(), relaxation.step), momentum = hn::Set(Tag(), relaxation.momentum);
    const bool has_momentum = relaxation.momentum != 0;  // without it `next` may hold anything
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        x.come_to(i);
        const Lanes3 x_i = x.own(i);
        const Lanes3 residual = xyz(load_rows(b + i)) - row_product(matrix, i, x, x_i);
        const Lanes3 moved = has_momentum ? mul_add(momentum, x_i - xyz(load_rows(next + i)), x_i) : x_i;
        store_rows(mul_add(step, preconditioned(matrix, i, residual), moved), hn::Zero(Tag()), next + i);
    }
}

/// step D_i^-1 b_i for the lanes from row i on.
template <class Matrix>
HWY_INLINE Lanes3 first_step(const Matrix& matrix, std::uint32_t i, const Vec4* b, float step) {
    return hn::Set(Tag(), step) * preconditioned(matrix, i, xyz(load_rows(b + i)));
}

/// x = step D^-1 b.
template <class Matrix>
void precondition_rows(const Matrix& matrix, const BlockRange& range, const Vec4* b, float step, Vec4* x) {
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes)
        store_rows(first_step(matrix, i, b, step), hn::Zero(Tag()), x + i);
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
