#include "cloth/implicit/coarse_matrix.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/implicit/coarse_matrix.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/implicit/lanes-inl.h"
#include "cloth/implicit/row_loops-inl.h"
#include "cloth/implicit/symmetric3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// Of a slot or a group, from lane `lane` on.
HWY_INLINE SymmetricLanes load_block(const AlignedBuffer<float>& values, std::uint32_t slot,
                                     std::uint32_t lane) {
    return load_symmetric(&values[std::size_t{slot} * CoarseMatrix::arrays * Stencil::lanes + lane]);
}

}  // namespace

// Found by the loops through their vectors' namespace, so not in the file's own.
HWY_INLINE Lanes3 row_product(const CoarseMatrix& matrix, std::uint32_t i, const Vec4* x, const Lanes3& x_i) {
    const Stencil& stencil = matrix.stencil;
    const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
    Lanes3 sum = load_block(matrix.ground, group, lane) * x_i;
    for (std::uint32_t s = stencil.group_slots[group]; s < stencil.group_slots[group + 1]; ++s)
        sum = sum + load_block(matrix.coefficients, s, lane) * (x_i - neighbour_rows(stencil, s, lane, x));
    return sum;
}

HWY_INLINE Lanes3 preconditioned(const CoarseMatrix& matrix, std::uint32_t i, const Lanes3& v) {
    return load_block(matrix.inverse_diagonal, i / Stencil::lanes, i % Stencil::lanes) * v;
}

namespace {

void subtract_product(const CoarseMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                      Vec4* remainder) {
    subtract_product_rows(matrix, range, b, x, remainder);
}

void relax(const CoarseMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
           const Relaxation& relaxation, Vec4* next) {
    relax_rows(matrix, range, b, x, relaxation, next);
}

void precondition(const CoarseMatrix& matrix, const BlockRange& range, const Vec4* b, float step, Vec4* x) {
    precondition_rows(matrix, range, b, step, x);
}

/// A_IJ of the links of a part of slot s.
HWY_INLINE SymmetricLanes gather_links(const CoarseMatrix& matrix, std::uint32_t s, std::uint32_t lane) {
    const Vec4* const rows = &matrix.links.data()->diagonal;
    const std::uint32_t* const picked = &matrix.link_rows[s * Stencil::lanes + lane];
    const Lanes3 diagonal = gather_rows(rows, picked), off_diagonal = gather_rows(rows + 1, picked);
    return {diagonal.x, diagonal.y, diagonal.z, off_diagonal.x, off_diagonal.z, off_diagonal.y};
}

// A coarse A_IJ alone may be indefinite, their sum is not; what rounding takes away is lifted. A node of
// pinned particles alone has no inertia, and stays where it is.
void finish(const BlockRange& range, CoarseMatrix& matrix) {
    const Stencil& stencil = matrix.stencil;
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
        const SymmetricLanes ground = load_block(matrix.ground, group, lane);
        SymmetricLanes diagonal = ground;
        for (std::uint32_t s = stencil.group_slots[group]; s < stencil.group_slots[group + 1]; ++s) {
            const SymmetricLanes block = gather_links(matrix, s, lane);
            store_symmetric(
                block, &matrix.coefficients[lane_index(s * Stencil::lanes + lane, 0, CoarseMatrix::arrays)]);
            diagonal = diagonal + block;
        }
        const Lanes inertia = hn::Add(hn::Add(ground.xx, ground.yy), ground.zz);
        const Lanes least = hn::Mul(hn::Set(Tag(), 0.003f), inertia);
        store_symmetric(keep_where(hn::Gt(inertia, hn::Zero(Tag())), inverse(diagonal, least)),
                        &matrix.inverse_diagonal[lane_index(i, 0, CoarseMatrix::arrays)]);
    }
}

/// Rows nodes[0], nodes[1], .. side by side, as many as fit.
template <class D>
HWY_INLINE hn::Vec<D> rows_side_by_side(D d, const Vec4* rows, const std::uint32_t* nodes) {
    if constexpr (hn::MaxLanes(D()) == 4) {
        return hn::Load(d, &rows[*nodes].x);
    } else {
        const hn::Half<D> half;
        return hn::Combine(d, rows_side_by_side(half, rows, nodes + hn::MaxLanes(half) / 4),
                           rows_side_by_side(half, rows, nodes));
    }
}

/// factors[0] four times, factors[1] four times, ..
HWY_INLINE Lanes each_four_times(const float* factors) {
    const Tag d;
    if constexpr (part_lanes == 4) {
        return hn::Set(d, *factors);
    } else {
        alignas(64) static constexpr std::int32_t picks[] = {0,  0,  0,  0,  5,  5,  5,  5,
                                                             10, 10, 10, 10, 15, 15, 15, 15};
        return hn::TableLookupLanes(hn::LoadDup128(d, factors), hn::SetTableIndices(d, picks));
    }
}

/// The sum of a register's rows of four.
template <class D>
HWY_INLINE hn::Vec<hn::FixedTag<float, 4>> sum_rows(D /*d*/, hn::Vec<D> v) {
    if constexpr (hn::MaxLanes(D()) == 4) {
        return v;
    } else {
        const hn::Half<D> half;
        return sum_rows(half, hn::Add(hn::LowerHalf(half, v), hn::UpperHalf(half, v)));
    }
}

/// The same, of 16 lanes' worth of registers, in the order in which one of 16 lanes would be summed: the
/// bytes do not depend on how many lanes there are.
template <class D>
HWY_INLINE hn::Vec<hn::FixedTag<float, 4>> sum_rows(D d, const hn::Vec<D>* parts) {
    constexpr std::uint32_t lanes = hn::MaxLanes(D());
    if constexpr (lanes == 4) {
        return hn::Add(hn::Add(parts[0], parts[2]), hn::Add(parts[1], parts[3]));
    } else {
        return sum_rows(d, lanes == 16 ? parts[0] : hn::Add(parts[0], parts[16 / lanes - 1]));
    }
}

// sum of f (d d^T + a I): the row (dx dy dz a) times (dx dy dz 1), and times (dy dz dx .).
void sum_springs(const GalerkinLists& lists, const BlockRange& range, const Vec4* springs,
                 CoarseMatrix& matrix) {
    const Tag d;
    const hn::FixedTag<float, 4> row;
    constexpr std::uint32_t at_once = part_lanes / 4, parts = 4 / at_once;  // of four terms
    alignas(64) static constexpr std::int32_t next_axis[] = {1, 2,  0, 3,  5,  6,  4,  7,
                                                             9, 10, 8, 11, 13, 14, 12, 15};
    const auto rotation = hn::SetTableIndices(d, next_axis);
    alignas(64) static constexpr float last_axis[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const Lanes one = hn::Set(d, 1.0f);
    const auto is_last = hn::Eq(hn::Load(d, last_axis), one);
    for (std::uint32_t k = range.begin; k < range.end; ++k) {
        Lanes squares[parts], products[parts];
        for (std::uint32_t part = 0; part < parts; ++part) squares[part] = products[part] = hn::Zero(d);
        for (std::uint32_t first = lists.offsets[k]; first < lists.offsets[k + 1]; first += 4) {
            for (std::uint32_t part = 0; part < parts; ++part) {
                const std::uint32_t t = first + part * at_once;
                const Lanes spring = rows_side_by_side(d, springs, &lists.fine_links[t]);
                const Lanes scaled = hn::Mul(each_four_times(&lists.factors[t]), spring);
                squares[part] = hn::MulAdd(scaled, hn::IfThenElse(is_last, one, spring), squares[part]);
                products[part] = hn::MulAdd(scaled, hn::TableLookupLanes(spring, rotation), products[part]);
            }
        }
        SplitBlock sum;
        hn::Store(sum_rows(d, squares), row, &sum.diagonal.x);
        hn::Store(sum_rows(d, products), row, &sum.off_diagonal.x);
        const float a = sum.diagonal.w;
        sum.diagonal = {sum.diagonal.x + a, sum.diagonal.y + a, sum.diagonal.z + a, 0};
        matrix.links[k] = sum;
    }
}

// Four terms at once, so that no sum waits for the one before.
void sum_links(const GalerkinLists& lists, const BlockRange& range, const SplitBlock* links,
               CoarseMatrix& matrix) {
    const hn::CappedTag<float, 8> d;
    constexpr std::uint32_t lanes = hn::MaxLanes(d);
    for (std::uint32_t k = range.begin; k < range.end; ++k) {
        SplitBlock sum;
        for (std::uint32_t part = 0; part < 8; part += lanes) {
            const auto plus_term = [&](std::uint32_t t, hn::Vec<decltype(d)> so_far) HWY_ATTR {
                const float* link = &links[lists.fine_links[t]].diagonal.x + part;
                return hn::MulAdd(hn::Set(d, lists.factors[t]), hn::Load(d, link), so_far);
            };
            auto sum0 = hn::Zero(d), sum1 = hn::Zero(d), sum2 = hn::Zero(d), sum3 = hn::Zero(d);
            for (std::uint32_t t = lists.offsets[k]; t < lists.offsets[k + 1]; t += 4) {
                sum0 = plus_term(t, sum0);
                sum1 = plus_term(t + 1, sum1);
                sum2 = plus_term(t + 2, sum2);
                sum3 = plus_term(t + 3, sum3);
            }
            hn::Store(hn::Add(hn::Add(sum0, sum1), hn::Add(sum2, sum3)), d, &sum.diagonal.x + part);
        }
        matrix.links[k] = sum;
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // what does not depend on the machine
namespace weft {

HWY_EXPORT(sum_springs);
HWY_EXPORT(sum_links);
HWY_EXPORT(finish);
HWY_EXPORT(subtract_product);
HWY_EXPORT(relax);
HWY_EXPORT(precondition);

CoarseMatrix::CoarseMatrix(const SpringGraph& graph, const std::vector<Link>& link_list)
    : stencil(graph.offsets, graph.neighbours),
      coefficients(arrays * stencil.neighbours.size()),
      ground(std::size_t{arrays} * stencil.groups() * Stencil::lanes),
      inverse_diagonal(ground.size()),
      links(link_list.size() + 1),
      link_rows(stencil.neighbours.size()) {
    const auto none = static_cast<std::uint32_t>(link_list.size());
    std::ranges::fill(link_rows.span(), 2 * none);
    // Links ascend, and so do the graph's rows: each row meets its links in order.
    std::vector<std::uint32_t> next(graph.offsets.begin(), graph.offsets.end() - 1);
    for (std::uint32_t k = 0; k < none; ++k) {
        for (const std::uint32_t node : {link_list[k].first, link_list[k].second})
            link_rows[stencil.entries[next[node]++]] = 2 * k;
    }
}

Symmetric3 CoarseMatrix::ground_of(std::uint32_t node) const {
    const float* g = &ground[lane_index(node, 0, arrays)];
    return {.xx = g[0], .yy = g[16], .zz = g[32], .xy = g[48], .xz = g[64], .yz = g[80]};
}

void CoarseMatrix::set_ground(std::uint32_t node, const Symmetric3& block) {
    const float values[] = {block.xx, block.yy, block.zz, block.xy, block.xz, block.yz};
    for (std::uint32_t k = 0; k < arrays; ++k) ground[lane_index(node, k, arrays)] = values[k];
}

std::size_t CoarseMatrix::bytes() const noexcept {
    return stencil.bytes() + coefficients.bytes() + ground.bytes() + inverse_diagonal.bytes() +
           links.bytes() + link_rows.bytes();
}

void sum_springs_block(const GalerkinLists& lists, const BlockRange& range, const Vec4* springs,
                       CoarseMatrix& matrix) {
    HWY_DYNAMIC_DISPATCH(sum_springs)(lists, range, springs, matrix);
}

void sum_links_block(const GalerkinLists& lists, const BlockRange& range, const SplitBlock* links,
                     CoarseMatrix& matrix) {
    HWY_DYNAMIC_DISPATCH(sum_links)(lists, range, links, matrix);
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
