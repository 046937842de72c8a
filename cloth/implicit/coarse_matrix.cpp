#include "cloth/implicit/coarse_matrix.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/implicit/coarse_matrix.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/implicit/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// A symmetric block in each lane.
struct LanesBlock {
    Lanes xx, yy, zz, xy, yz, zx;

    HWY_INLINE Lanes3 operator*(const Lanes3& v) const {
        return {dot({xx, xy, zx}, v), dot({xy, yy, yz}, v), dot({zx, yz, zz}, v)};
    }
};
HWY_INLINE LanesBlock operator+(const LanesBlock& a, const LanesBlock& b) {
    return {hn::Add(a.xx, b.xx), hn::Add(a.yy, b.yy), hn::Add(a.zz, b.zz),
            hn::Add(a.xy, b.xy), hn::Add(a.yz, b.yz), hn::Add(a.zx, b.zx)};
}
/// Of a slot or a group, from lane `lane` on.
HWY_INLINE LanesBlock load_block(const AlignedBuffer<float>& values, std::uint32_t slot, std::uint32_t lane) {
    const float* at = &values[std::size_t{slot} * CoarseMatrix::arrays * Stencil::lanes + lane];
    constexpr std::uint32_t next = Stencil::lanes;
    return {load_lanes(at),
            load_lanes(at + next),
            load_lanes(at + 2 * next),
            load_lanes(at + 3 * next),
            load_lanes(at + 4 * next),
            load_lanes(at + 5 * next)};
}

HWY_INLINE Lanes3 row_product(const CoarseMatrix& matrix, std::uint32_t i, const Vec4* x, const Lanes3& x_i) {
    const Stencil& stencil = matrix.stencil;
    const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
    Lanes3 sum = load_block(matrix.ground, group, lane) * x_i;
    const Lanes one = hn::Set(Tag(), 1.0f);
    for (std::uint32_t s = stencil.group_slots[group]; s < stencil.group_slots[group + 1]; ++s) {
        const Lanes3 difference = x_i - neighbour_rows(stencil, s, lane, x);
        sum = mul_add(one, load_block(matrix.coefficients, s, lane) * difference, sum);
    }
    return sum;
}

HWY_INLINE Lanes3 preconditioned(const CoarseMatrix& matrix, std::uint32_t i, const Lanes3& v) {
    return load_block(matrix.inverse_diagonal, i / Stencil::lanes, i % Stencil::lanes) * v;
}

void residual(const CoarseMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x, Vec4* out) {
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const Lanes3 row = row_product(matrix, i, x, xyz(load_rows(x + i)));
        store_rows(xyz(load_rows(b + i)) - row, hn::Zero(Tag()), out + i);
    }
}

void relax(const CoarseMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
           const Relaxation& relaxation, Vec4* next) {
    const Lanes step = hn::Set(Tag(), relaxation.step), momentum = hn::Set(Tag(), relaxation.momentum);
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const Lanes3 x_i = xyz(load_rows(x + i));
        const Lanes3 left = xyz(load_rows(b + i)) - row_product(matrix, i, x, x_i);
        const Lanes3 moved = mul_add(momentum, x_i - xyz(load_rows(next + i)), x_i);
        store_rows(mul_add(step, preconditioned(matrix, i, left), moved), hn::Zero(Tag()), next + i);
    }
}

void precondition(const CoarseMatrix& matrix, const BlockRange& range, const Vec4* b, float step, Vec4* x) {
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const Lanes3 v = preconditioned(matrix, i, xyz(load_rows(b + i)));
        store_rows(hn::Set(Tag(), step) * v, hn::Zero(Tag()), x + i);
    }
}

/// The sum of a register's quarters.
HWY_INLINE hn::Vec<hn::FixedTag<float, 4>> sum_quarters(Lanes v) {
    const hn::FixedTag<float, 4> row;
    alignas(64) float values[part_lanes];
    hn::Store(v, Tag(), values);
    auto sum = hn::Load(row, values);
    for (std::uint32_t k = 4; k < part_lanes; k += 4) sum = hn::Add(sum, hn::Load(row, values + k));
    return sum;
}

HWY_INLINE void store_link(const Vec4& diagonal, const Vec4& off_diagonal, std::uint32_t link,
                           CoarseMatrix& matrix) {
    matrix.links[link] = {diagonal, off_diagonal};
    const float values[] = {diagonal.x,     diagonal.y,     diagonal.z,
                            off_diagonal.x, off_diagonal.y, off_diagonal.z};
    float* first = &matrix.coefficients[lane_index(matrix.entries[link].at_first, 0, CoarseMatrix::arrays)];
    float* second = &matrix.coefficients[lane_index(matrix.entries[link].at_second, 0, CoarseMatrix::arrays)];
    for (std::uint32_t k = 0; k < CoarseMatrix::arrays; ++k)
        first[k * Stencil::lanes] = second[k * Stencil::lanes] = values[k];
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
        alignas(64) static constexpr std::int32_t picks[16] = {0,  0,  0,  0,  5,  5,  5,  5,
                                                               10, 10, 10, 10, 15, 15, 15, 15};
        return hn::TableLookupLanes(hn::LoadDup128(d, factors), hn::SetTableIndices(d, picks));
    }
}

// sum of f (d d^T + s^2 I): the register (dx dy dz s) times itself, and times its rotation (dy dz dx s).
void sum_springs(const GalerkinLists& lists, const BlockRange& range, const Vec4* springs,
                 CoarseMatrix& matrix) {
    const Tag d;
    const hn::FixedTag<float, 4> row;
    constexpr std::uint32_t at_once = part_lanes / 4;
    alignas(64) static constexpr std::int32_t next_axis[16] = {1, 2,  0, 3,  5,  6,  4,  7,
                                                               9, 10, 8, 11, 13, 14, 12, 15};
    const auto rotation = hn::SetTableIndices(d, next_axis);
    for (std::uint32_t k = range.begin; k < range.end; ++k) {
        Lanes squares = hn::Zero(d), products = hn::Zero(d);
        for (std::uint32_t t = lists.offsets[k]; t < lists.offsets[k + 1]; t += at_once) {
            const Lanes spring = rows_side_by_side(d, springs, &lists.fine_links[t]);
            const Lanes scaled = hn::Mul(each_four_times(&lists.factors[t]), spring);
            squares = hn::MulAdd(scaled, spring, squares);
            products = hn::MulAdd(scaled, hn::TableLookupLanes(spring, rotation), products);
        }
        SplitBlock sum;
        hn::Store(sum_quarters(squares), row, &sum.diagonal.x);
        hn::Store(sum_quarters(products), row, &sum.off_diagonal.x);
        const float a = sum.diagonal.w;
        store_link({sum.diagonal.x + a, sum.diagonal.y + a, sum.diagonal.z + a, 0}, sum.off_diagonal, k,
                   matrix);
    }
}

void sum_links(const GalerkinLists& lists, const BlockRange& range, const SplitBlock* links,
               CoarseMatrix& matrix) {
    const hn::FixedTag<float, 4> row;
    for (std::uint32_t k = range.begin; k < range.end; ++k) {
        auto diagonal = hn::Zero(row), off_diagonal = hn::Zero(row);
        for (std::uint32_t t = lists.offsets[k]; t < lists.offsets[k + 1]; ++t) {
            const SplitBlock& link = links[lists.fine_links[t]];
            const auto factor = hn::Set(row, lists.factors[t]);
            diagonal = hn::MulAdd(factor, hn::Load(row, &link.diagonal.x), diagonal);
            off_diagonal = hn::MulAdd(factor, hn::Load(row, &link.off_diagonal.x), off_diagonal);
        }
        SplitBlock sum;
        hn::Store(diagonal, row, &sum.diagonal.x);
        hn::Store(off_diagonal, row, &sum.off_diagonal.x);
        store_link(sum.diagonal, sum.off_diagonal, k, matrix);
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // what does not depend on the machine
namespace weft {

HWY_EXPORT(sum_springs);
HWY_EXPORT(sum_links);
HWY_EXPORT(residual);
HWY_EXPORT(relax);
HWY_EXPORT(precondition);

CoarseMatrix::CoarseMatrix(const SpringGraph& graph, const std::vector<Link>& link_list)
    : stencil(graph.offsets, graph.neighbours),
      coefficients(arrays * stencil.neighbours.size()),
      ground(std::size_t{arrays} * stencil.groups() * Stencil::lanes),
      inverse_diagonal(ground.size()),
      links(link_list.size()),
      entries(link_list.size()) {
    // Links ascend, and so do the graph's rows: each row meets its links in order.
    std::vector<std::uint32_t> next(graph.offsets.begin(), graph.offsets.end() - 1);
    for (std::size_t k = 0; k < link_list.size(); ++k) {
        const Link& link = link_list[k];
        entries[k] = {stencil.entries[next[link.first]++], stencil.entries[next[link.second]++]};
    }
}

Symmetric3 CoarseMatrix::ground_of(std::uint32_t node) const {
    const float* g = &ground[lane_index(node, 0, arrays)];
    return {.xx = g[0], .yy = g[16], .zz = g[32], .xy = g[48], .xz = g[80], .yz = g[64]};
}

namespace {
void store_block(const Symmetric3& block, std::uint32_t node, AlignedBuffer<float>& values) {
    const float entries[] = {block.xx, block.yy, block.zz, block.xy, block.yz, block.xz};
    for (std::uint32_t k = 0; k < CoarseMatrix::arrays; ++k)
        values[lane_index(node, k, CoarseMatrix::arrays)] = entries[k];
}
}  // namespace

void CoarseMatrix::set_ground(std::uint32_t node, const Symmetric3& block) {
    store_block(block, node, ground);
}

std::size_t CoarseMatrix::bytes() const noexcept {
    return stencil.bytes() + coefficients.bytes() + ground.bytes() + inverse_diagonal.bytes() +
           links.bytes() + entries.bytes();
}

void sum_springs_block(const GalerkinLists& lists, const BlockRange& range, const Vec4* springs,
                       CoarseMatrix& matrix) {
    HWY_DYNAMIC_DISPATCH(sum_springs)(lists, range, springs, matrix);
}

void sum_links_block(const GalerkinLists& lists, const BlockRange& range, const SplitBlock* links,
                     CoarseMatrix& matrix) {
    HWY_DYNAMIC_DISPATCH(sum_links)(lists, range, links, matrix);
}

// A coarse A_IJ alone may be indefinite, their sum is not; what rounding takes away is lifted. A node of
// pinned particles alone has no inertia, and stays where it is.
void invert_diagonal_block(const BlockRange& range, CoarseMatrix& matrix) {
    const Stencil& stencil = matrix.stencil;
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
        const Symmetric3 ground = matrix.ground_of(i);
        Symmetric3 diagonal = ground;
        const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
        for (std::uint32_t s = stencil.group_slots[group]; s < stencil.group_slots[group + 1]; ++s) {
            const float* c =
                &matrix.coefficients[lane_index(s * Stencil::lanes + lane, 0, CoarseMatrix::arrays)];
            diagonal.add_scaled(1.0f, {.xx = c[0], .yy = c[16], .zz = c[32], .xy = c[48], .xz = c[80], .yz = c[64]});
        }
        const float inertia = (ground.xx + ground.yy + ground.zz) / 3;
        store_block(inertia > 0 ? inverse(diagonal, 0.01f * inertia) : Symmetric3{}, i,
                    matrix.inverse_diagonal);
    }
}

void residual_block(const CoarseMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                    Vec4* residual) {
    HWY_DYNAMIC_DISPATCH(residual)(matrix, range, b, x, residual);
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
