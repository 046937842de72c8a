#include "cloth/solver/levels/coarse/coarse_matrix.h"

#include <algorithm>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/solver/levels/coarse/coarse_matrix.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/equation/external_row-inl.h"
#include "cloth/equation/row_loops-inl.h"
#include "cloth/equation/sparse/stencil-inl.h"
#include "engine/simd/symmetric3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// The block of a slot or a group, from lane `lane` on.
HWY_INLINE SymmetricLanes load_block(const ScratchArray<float>& values, std::uint32_t slot,
                                     std::uint32_t lane) {
    return load_symmetric(&values[std::size_t{slot} * CoarseMatrix::arrays * Stencil::lanes + lane]);
}

}  // namespace

// The row loops find these by argument-dependent lookup, so they are not in the anonymous namespace.
HWY_INLINE Lanes3 row_product(const CoarseMatrix& matrix, std::uint32_t i, const RowsInMemory& x,
                              const Lanes3& x_i) {
    const Stencil& stencil = matrix.stencil;
    const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
    Lanes3 sum = load_block(matrix.ground, group, lane) * x_i;
    for (std::uint32_t s = stencil.group_slots[group]; s < stencil.group_slots[group + 1]; ++s)
        sum = sum + load_block(matrix.coefficients, s, lane) * (x_i - x.neighbours(s, lane));
    return sum;
}

HWY_INLINE Lanes3 preconditioned(const CoarseMatrix& matrix, std::uint32_t i, const Lanes3& v) {
    return load_block(matrix.inverse_diagonal, i / Stencil::lanes, i % Stencil::lanes) * v;
}

namespace {

void subtract_product(const CoarseMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                      Vec4* remainder) {
    RowsInMemory rows{matrix.stencil, x};
    subtract_product_rows(matrix, range, b, rows, remainder);
}

void relax(const CoarseMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
           const Relaxation& relaxation, Vec4* next) {
    RowsInMemory rows{matrix.stencil, x};
    relax_rows(matrix, range, b, rows, relaxation, next);
}

void precondition(const CoarseMatrix& matrix, const BlockRange& range, const Vec4* b, float step, Vec4* x) {
    precondition_rows(matrix, range, b, step, x);
}

HWY_INLINE SymmetricLanes symmetric_of(const Lanes3& diagonal, const Lanes3& off_diagonal) {
    return {diagonal.x, diagonal.y, diagonal.z, off_diagonal.x, off_diagonal.y, off_diagonal.z};
}
HWY_INLINE void store_as_rows(const SymmetricLanes& m, Vec4* diagonal, Vec4* off_diagonal) {
    store_rows({m.xx, m.yy, m.zz}, set(0), diagonal);
    store_rows({m.xy, m.xz, m.yz}, set(0), off_diagonal);
}
template <class Number>
HWY_INLINE SymmetricLanes gather_blocks(const SymmetricRows& rows, std::uint32_t base,
                                        const Number* numbers) {
    return symmetric_of(gather_rows(rows.diagonal.data() + base, numbers),
                        gather_rows(rows.off_diagonal.data() + base, numbers));
}

// A coarse A_IJ alone may be indefinite, but their sum is not; the diagonal is lifted against rounding. A
// node of pinned particles alone has no inertia and does not move.
void finish(const BlockRange& range, CoarseMatrix& matrix) {
    const Stencil& stencil = matrix.stencil;
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
        const SymmetricLanes ground = symmetric_of(xyz(load_rows(&matrix.ground_rows.diagonal[i])),
                                                   xyz(load_rows(&matrix.ground_rows.off_diagonal[i])));
        store_symmetric(ground, &matrix.ground[lane_index(i, 0, CoarseMatrix::arrays)]);
        SymmetricLanes diagonal = ground;
        for (std::uint32_t s = stencil.group_slots[group]; s < stencil.group_slots[group + 1]; ++s) {
            const std::uint32_t entry = s * Stencil::lanes + lane;
            const SymmetricLanes block = gather_blocks(matrix.links, 0, &matrix.link_rows[entry]);
            store_symmetric(block, &matrix.coefficients[lane_index(entry, 0, CoarseMatrix::arrays)]);
            diagonal = diagonal + block;
        }
        const Lanes inertia = hn::Add(hn::Add(ground.xx, ground.yy), ground.zz);
        const Lanes least = hn::Mul(hn::Set(Tag(), 0.003f), inertia);
        store_symmetric(keep_where(hn::Gt(inertia, hn::Zero(Tag())), inverse(diagonal, least)),
                        &matrix.inverse_diagonal[lane_index(i, 0, CoarseMatrix::arrays)]);
    }
}

void ground_rows(const BlockRange& range, const Vec4* right_side, const ContactRows* contacts, Vec4* diagonal,
                 Vec4* off_diagonal) {
    const Lanes zero = set(0);
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const Lanes row_sum = load_rows(right_side + i).w;
        SymmetricLanes ground = add_identity(zero_symmetric(), row_sum);
        if (touches(contacts, i)) ground = add_identity(contact_blocks(*contacts, i), row_sum);
        store_rows({ground.xx, ground.yy, ground.zz}, zero, diagonal + i);
        if (contacts != nullptr) store_rows({ground.xy, ground.xz, ground.yz}, zero, off_diagonal + i);
    }
}

/// sums = sum of add_term(sum so far, factors, the group's base, numbers of fine links from there), lane by
/// lane.
template <class Number, class First, class AddTerm>
HWY_INLINE void sum_terms_by(const SharedBuffer<Number>& numbers, const GalerkinLists& lists,
                             const BlockRange& range, const First& first, const AddTerm& add_term,
                             SymmetricRows& sums) {
    constexpr bool is_packed = sizeof(Number) < sizeof(std::uint32_t);
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
        const std::uint32_t base = is_packed ? lists.fine_links.bases[group] : 0;
        SymmetricLanes sum = first(i);
        for (std::uint32_t s = lists.group_slots[group]; s < lists.group_slots[group + 1]; ++s) {
            const std::uint32_t entry = s * Stencil::lanes + lane;
            sum = add_term(sum, load_lanes(&lists.factors[entry]), base, &numbers[entry]);
        }
        store_as_rows(sum, &sums.diagonal[i], &sums.off_diagonal[i]);
    }
}
template <class First, class AddTerm>
HWY_INLINE void sum_terms(const GalerkinLists& lists, const BlockRange& range, const First& first,
                          const AddTerm& add_term, SymmetricRows& sums) {
    if (lists.fine_links.is_packed())
        sum_terms_by(lists.fine_links.from_base, lists, range, first, add_term, sums);
    else
        sum_terms_by(lists.fine_links.numbers, lists, range, first, add_term, sums);
}

/// sum + factor (d d^T + a I).
HWY_INLINE SymmetricLanes add_spring(const SymmetricLanes& sum, Lanes factor, const Lanes3& d, Lanes a) {
    const Lanes3 scaled = factor * d;
    return {hn::MulAdd(scaled.x, d.x, hn::MulAdd(factor, a, sum.xx)),
            hn::MulAdd(scaled.y, d.y, hn::MulAdd(factor, a, sum.yy)),
            hn::MulAdd(scaled.z, d.z, hn::MulAdd(factor, a, sum.zz)),
            hn::MulAdd(scaled.x, d.y, sum.xy),
            hn::MulAdd(scaled.x, d.z, sum.xz),
            hn::MulAdd(scaled.y, d.z, sum.yz)};
}

HWY_INLINE Lanes load_rounded(const double* values) {
    const hn::Half<Tag> half;
    const hn::Rebind<double, decltype(half)> d;
    return hn::Combine(Tag(), hn::DemoteTo(half, hn::Load(d, values + part_lanes / 2)),
                       hn::DemoteTo(half, hn::Load(d, values)));
}

void sum_springs(const GalerkinLists& lists, const BlockRange& range, const Vec4* springs,
                 const double* constants, float scale, SymmetricRows& sums) {
    const auto of_constants = [&](std::uint32_t i) HWY_ATTR {
        return add_identity(zero_symmetric(), hn::Mul(set(scale), load_rounded(constants + i)));
    };
    const auto add = [springs](const auto& sum, Lanes factor, std::uint32_t base, const auto* numbers)
                         HWY_ATTR {
                             const Lanes4 spring = gather_rows_with_w(springs + base, numbers);
                             return add_spring(sum, factor, xyz(spring), spring.w);
                         };
    sum_terms(lists, range, of_constants, add, sums);
}

void sum_links(const GalerkinLists& lists, const BlockRange& range, const SymmetricRows& links,
               SymmetricRows& sums) {
    const auto add = [&links](const auto& sum, Lanes factor, std::uint32_t base, const auto* numbers)
                         HWY_ATTR { return sum + factor * gather_blocks(links, base, numbers); };
    const auto nothing = [](std::uint32_t) HWY_ATTR { return zero_symmetric(); };
    sum_terms(lists, range, nothing, add, sums);
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // code that does not depend on the machine
namespace weft {

HWY_EXPORT(ground_rows);
HWY_EXPORT(sum_springs);
HWY_EXPORT(sum_links);
HWY_EXPORT(finish);
HWY_EXPORT(subtract_product);
HWY_EXPORT(relax);
HWY_EXPORT(precondition);

CoarseMatrix::CoarseMatrix(const SpringGraph& graph, const CoarseLinks& of)
    : stencil(graph.offsets, graph.neighbours), link_rows(stencil.neighbours.size()) {
    std::ranges::fill(link_rows.span(), of.lists.groups() * Stencil::lanes);
    // Links ascend, and so do the graph's rows: each row meets its links in order.
    std::vector<std::uint32_t> next(graph.offsets.begin(), graph.offsets.end() - 1);
    for (std::size_t k = 0; k < of.links.size(); ++k) {
        for (const std::uint32_t node : {of.links[k].first, of.links[k].second})
            link_rows[stencil.entry(node, next[node]++)] = of.places[k];
    }
    stencil.slot_of = {};
}

std::uint32_t CoarseMatrix::place_between(const Link& link, const GalerkinLists& lists) const noexcept {
    const std::uint32_t group = link.first / Stencil::lanes, lane = link.first % Stencil::lanes;
    for (std::uint32_t s = stencil.group_slots[group]; s < stencil.group_slots[group + 1]; ++s)
        if (stencil.neighbours[s * Stencil::lanes + lane] == link.second)
            return link_rows[s * Stencil::lanes + lane];
    return lists.groups() * Stencil::lanes;
}

void CoarseMatrix::lay_out_sums(Scratch& scratch, const GalerkinLists& lists) {
    ground_rows.lay_out(scratch, stencil.nodes);
    links.lay_out(scratch, lists.groups() * Stencil::lanes + 1);
}

void CoarseMatrix::lay_out_matrix(Scratch& scratch) {
    scratch.take(coefficients, arrays * stencil.neighbours.size());
    scratch.take(ground, std::size_t{arrays} * stencil.groups() * Stencil::lanes);
    scratch.take(inverse_diagonal, ground.size());
}

void ground_rows_block(const BlockRange& range, const Vec4* right_side, const ContactRows* contacts,
                       Vec4* diagonal, Vec4* off_diagonal) {
    HWY_DYNAMIC_DISPATCH(ground_rows)(range, right_side, contacts, diagonal, off_diagonal);
}

void sum_springs_block(const GalerkinLists& lists, const BlockRange& range, const Vec4* springs,
                       const double* constants, float scale, SymmetricRows& sums) {
    HWY_DYNAMIC_DISPATCH(sum_springs)(lists, range, springs, constants, scale, sums);
}

void sum_links_block(const GalerkinLists& lists, const BlockRange& range, const SymmetricRows& links,
                     SymmetricRows& sums) {
    HWY_DYNAMIC_DISPATCH(sum_links)(lists, range, links, sums);
}

void finish_block(const BlockRange& range, CoarseMatrix& matrix) {
    HWY_DYNAMIC_DISPATCH(finish)(range, matrix);
}

void subtract_product_block(const CoarseMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                            Vec4* remainder) {
    HWY_DYNAMIC_DISPATCH(subtract_product)(matrix, range, b, x, remainder);
}

void relax_block(const CoarseMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                 Relaxation relaxation, Vec4* next) {
    HWY_DYNAMIC_DISPATCH(relax)(matrix, range, b, x, relaxation, next);
}

void precondition_block(const CoarseMatrix& matrix, const BlockRange& range, const Vec4* b, float step,
                        Vec4* x) {
    HWY_DYNAMIC_DISPATCH(precondition)(matrix, range, b, step, x);
}

}  // namespace weft
#endif
