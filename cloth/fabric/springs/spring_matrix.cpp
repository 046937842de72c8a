#include "cloth/fabric/springs/spring_matrix.h"

#include <array>
#include <cmath>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/fabric/springs/spring_matrix.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/equation/grid/grid_windows-inl.h"
#include "cloth/equation/row_loops-inl.h"
#include "cloth/equation/sparse/stencil-inl.h"
#include "cloth/equation/sparse/transfers-inl.h"
#include "cloth/fabric/springs/whole_row-inl.h"
#include "engine/simd/half_precision-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
// The loops find these by argument-dependent lookup, so they are not in the anonymous namespace.
/// (a I + d d^T) v.
HWY_INLINE Lanes3 times(const SpringBlockLanes& block, const Lanes3& v) {
    return mul_add(dot(block.d, v), block.d, block.a * v);
}

/// D_i^-1 v for the lanes from particle `i` on.
HWY_INLINE Lanes3 preconditioned(const SpringMatrix& matrix, std::uint32_t i, const Lanes3& v) {
    return load_symmetric(&matrix.inverse_diagonal[lane_index(i, 0, 6)]) * v;
}

// Vectors whose rows a loop over a grid reads or computes as it comes to them.

struct InMemory {
    const Vec4* rows;

    HWY_INLINE Lanes3 operator()(std::uint32_t i) const { return xyz(load_rows(rows + i)); }
};

/// The vector step D^-1 b.
struct FirstStep {
    const SpringMatrix& matrix;
    const Vec4* b;
    float step;

    HWY_INLINE Lanes3 operator()(std::uint32_t i) const { return first_step(matrix, i, b, step); }
};

/// The vector step D^-1 b + P e.
struct CorrectedFirstStep {
    FirstStep first;
    const Correction& correction;

    HWY_INLINE Lanes3 operator()(std::uint32_t i) const {
        const Rows rows = rows_from(
            [&](std::uint32_t k) HWY_ATTR { return corrected(correction, i + k, hn::Zero(RowTag())); });
        return first(i) + lanes_of(rows);
    }
};

/// A vector's rows in a grid, to be multiplied by the matrix in ascending order.
template <class Vector>
class RowsOfGrid {
  public:
    HWY_INLINE RowsOfGrid(const SpringMatrix& matrix, const BlockRange& range, const Vector& vector,
                          GridWindow& window)
        : matrix_(matrix), vector_(vector), loop_(window, matrix.diagonals, range) {
        for (std::uint32_t i = loop_.first(); i < range.begin; i += part_lanes) {
            come_to(i);
            add_later(i, own(i), zero3());
            loop_.go_on();
        }
    }
    HWY_INLINE void come_to(std::uint32_t /*i*/) {
        loop_.read_ahead([this](std::uint32_t j) HWY_ATTR { return std::array<Lanes3, 1>{vector_(j)}; });
    }
    HWY_INLINE Lanes3 own(std::uint32_t /*i*/) const { return loop_.own(0); }

    /// Returns sum_j A_ij (x_i - x_j) in square units for the lanes from particle `i` on. Advances the loop.
    HWY_INLINE Lanes3 sum_of_springs(std::uint32_t i, const Lanes3& x_i) {
        Lanes3 sum = zero3();
        const auto take = [&sum](std::uint32_t /*d*/, const Given& given)
                              HWY_ATTR { sum = sum - given.xyz(0); };
        loop_.take_from_far(take);
        sum = add_later(i, x_i, sum);
        loop_.take_from_near(take);
        loop_.go_on();
        return sum;
    }

  private:
    HWY_INLINE Lanes3 add_later(std::uint32_t i, const Lanes3& x_i, Lanes3 sum) const {
        const std::uint16_t* block = matrix_.coefficients.data() +
                                     matrix_.halves_of_diagonal(i / Stencil::lanes, 0) + i % Stencil::lanes;
        for (std::uint32_t d = 0; d < loop_.diagonals(); ++d) {
            const Lanes3 apart = x_i - loop_.later(0, d);
            const bool only_bends = matrix_.isotropic[d];
            const Lanes3 term = only_bends ? load_halves(block) * apart : times(load_block(block), apart);
            block += only_bends ? Stencil::lanes : 4 * Stencil::lanes;
            loop_.give(d, term.x, term.y, term.z);
            sum = sum + term;
        }
        return sum;
    }

    const SpringMatrix& matrix_;
    const Vector vector_;
    GridLoop<1, 3> loop_;
};

template <class Vector>
HWY_INLINE Lanes3 sum_of_springs(const SpringMatrix& /*matrix*/, std::uint32_t i, RowsOfGrid<Vector>& x,
                                 const Lanes3& x_i) {
    return x.sum_of_springs(i, x_i);
}

HWY_INLINE Lanes3 sum_of_springs(const SpringMatrix& matrix, std::uint32_t i, const RowsInMemory& x,
                                 const Lanes3& x_i) {
    Lanes3 sum = zero3();
    const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
    const std::uint32_t begin = x.stencil.group_slots[group], end = x.stencil.group_slots[group + 1];
    const std::uint32_t bending = begin + matrix.springs_of(group);
    const auto difference = [&](std::uint32_t s) HWY_ATTR {
        return x_i - gather_rows(x.rows, &x.stencil.neighbours[s * Stencil::lanes + lane]);
    };
    const std::uint16_t* halves = matrix.coefficients.data() + matrix.halves(group, 0) + lane;
    for (std::uint32_t s = begin; s < bending; ++s, halves += 4 * Stencil::lanes) {
        const auto [a, d] = load_block(halves);
        const Lanes3 apart = difference(s);
        sum = mul_add(dot(d, apart), d, mul_add(a, apart, sum));
    }
    for (std::uint32_t s = bending; s < end; ++s, halves += Stencil::lanes)
        sum = mul_add(load_halves(halves), difference(s), sum);
    return sum;
}

/// (W x)_i for the lanes from particle `i` on.
template <class Rows>
HWY_INLINE Lanes3 row_product(const SpringMatrix& matrix, std::uint32_t i, Rows& x, const Lanes3& x_i) {
    return whole_row(matrix, i, x_i, sum_of_springs(matrix, i, x, x_i));
}

namespace {

/// Calls loop(rows) with the rows of x: in memory, or in a grid's window.
template <class Loop>
HWY_INLINE auto with_rows(const SpringMatrix& matrix, const BlockRange& range, const Vec4* x,
                          GridWindow* window, const Loop& loop) {
    if (window == nullptr) {
        RowsInMemory rows{matrix.stencil, x};
        return loop(rows);
    }
    RowsOfGrid rows(matrix, range, InMemory{x}, *window);
    return loop(rows);
}

Products multiply(const SpringMatrix& matrix, const BlockRange& range, const DottedWith& with, const Vec4* x,
                  Vec4* product, GridWindow* window) {
    return with_rows(matrix, range, x, window,
                     [&](auto& rows) HWY_ATTR { return multiply_rows(matrix, range, with, rows, product); });
}

void subtract_product(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                      Vec4* remainder, GridWindow* window) {
    with_rows(matrix, range, x, window,
              [&](auto& rows) HWY_ATTR { subtract_product_rows(matrix, range, b, rows, remainder); });
}

void relax(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
           const Relaxation& relaxation, Vec4* next, GridWindow* window) {
    with_rows(matrix, range, x, window,
              [&](auto& rows) HWY_ATTR { relax_rows(matrix, range, b, rows, relaxation, next); });
}

void subtract_first_step(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, float step,
                         Vec4* remainder, GridWindow& window) {
    RowsOfGrid rows(matrix, range, FirstStep{matrix, b, step}, window);
    subtract_product_rows(matrix, range, b, rows, remainder);
}

void relax_corrected(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, float step,
                     const Correction& correction, Vec4* next, GridWindow& window) {
    RowsOfGrid rows(matrix, range, CorrectedFirstStep{{matrix, b, step}, correction}, window);
    relax_rows(matrix, range, b, rows, {.step = step}, next);
}

void precondition(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, float step, Vec4* x) {
    precondition_rows(matrix, range, b, step, x);
}

/// The halves of a slot, and whether d is stored among them.
struct SlotHalves {
    const std::uint16_t* first;
    bool has_d;
};
SlotHalves halves_of(const SpringMatrix& matrix, std::uint32_t slot) {
    const std::uint16_t* const all = matrix.coefficients.data();
    if (!matrix.diagonals.empty()) {
        const std::uint32_t d = slot % matrix.diagonals.count;
        return {all + matrix.halves_of_diagonal(slot / matrix.diagonals.count, d), !matrix.isotropic[d]};
    }
    const std::uint32_t group = matrix.stencil.group_of(slot), first = matrix.stencil.group_slots[group];
    return {all + matrix.halves(group, slot - first), slot - first < matrix.springs_of(group)};
}

void unpack(const SpringMatrix& matrix, const BlockRange& range, const std::uint32_t* slots, Vec4* blocks) {
    const Lanes unit = hn::Set(Tag(), matrix.unit), squared_unit = hn::Mul(unit, unit);
    for (std::uint32_t k = range.begin; k < range.end; ++k) {
        const auto [halves, has_d] = halves_of(matrix, slots[k]);
        for (std::uint32_t lane = 0; lane < Stencil::lanes; lane += part_lanes) {
            const auto [a, d] =
                has_d ? load_block(halves + lane) : SpringBlockLanes{load_halves(halves + lane), zero3()};
            store_rows(unit * d, hn::Mul(squared_unit, a), blocks + k * Stencil::lanes + lane);
        }
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // compiled once, not for each instruction set
namespace weft {

HWY_EXPORT(multiply);
HWY_EXPORT(subtract_product);
HWY_EXPORT(relax);
HWY_EXPORT(subtract_first_step);
HWY_EXPORT(relax_corrected);
HWY_EXPORT(precondition);
HWY_EXPORT(unpack);

// The last group is zeroed: narrow vectors do not write all of its lanes, but read D^-1 b ahead to its end.
void SpringMatrix::lay_out(Scratch& scratch) {
    constexpr std::size_t of_group = std::size_t{6} * Stencil::lanes;
    scratch.take(coefficients, all_halves());
    scratch.take(row_sums, stencil.nodes);
    scratch.take(inverse_diagonal, of_group * stencil.groups());
    if (scratch.has_memory()) std::ranges::fill(inverse_diagonal.span().last(of_group), 0.0f);
}

// Halves reach from 2^-14 (2^-24 with fewer digits) to 2^16. With |d| of at most 2^7 units, a is at most 2^14
// square units, and the softest spring that keeps its digits is 2^28 times softer than the stiffest.
void SpringMatrix::set_unit(float largest_block) {
    int exponent = 0;
    std::frexp(std::sqrt(largest_block), &exponent);
    unit = largest_block > 0 ? std::ldexp(1.0f, exponent - 7) : 1.0f;
}

Products multiply_block(const SpringMatrix& matrix, const BlockRange& range, const DottedWith& with,
                        const Vec4* x, Vec4* product, GridWindow* window) {
    return HWY_DYNAMIC_DISPATCH(multiply)(matrix, range, with, x, product, window);
}

void subtract_product_block(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                            Vec4* remainder, GridWindow* window) {
    HWY_DYNAMIC_DISPATCH(subtract_product)(matrix, range, b, x, remainder, window);
}

void relax_block(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                 Relaxation relaxation, Vec4* next, GridWindow* window) {
    HWY_DYNAMIC_DISPATCH(relax)(matrix, range, b, x, relaxation, next, window);
}

void subtract_first_step_block(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, float step,
                               Vec4* remainder, GridWindow& window) {
    HWY_DYNAMIC_DISPATCH(subtract_first_step)(matrix, range, b, step, remainder, window);
}

void relax_corrected_block(const SpringMatrix& matrix, const BlockRange& range, const Vec4* b, float step,
                           const Correction& correction, Vec4* next, GridWindow& window) {
    HWY_DYNAMIC_DISPATCH(relax_corrected)(matrix, range, b, step, correction, next, window);
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
