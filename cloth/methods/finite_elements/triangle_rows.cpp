#include "cloth/methods/finite_elements/triangle_rows.h"

#include <algorithm>

#include "engine/simd/symmetric3.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/methods/finite_elements/triangle_rows.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/equation/external_row-inl.h"
#include "cloth/equation/sparse/stencil-inl.h"
#include "engine/simd/symmetric3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// A 3x3 block in each lane.
struct BlockLanes {
    Lanes3 x, y, z;

    HWY_INLINE Lanes3 operator*(const Lanes3& v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
};
HWY_INLINE BlockLanes operator+(const BlockLanes& a, const BlockLanes& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Mask>
HWY_INLINE BlockLanes transposed_unless(Mask mask, const BlockLanes& b) {
    return {{b.x.x, hn::IfThenElse(mask, b.x.y, b.y.x), hn::IfThenElse(mask, b.x.z, b.z.x)},
            {hn::IfThenElse(mask, b.y.x, b.x.y), b.y.y, hn::IfThenElse(mask, b.y.z, b.z.y)},
            {hn::IfThenElse(mask, b.z.x, b.x.z), hn::IfThenElse(mask, b.z.y, b.y.z), b.z.z}};
}

/// factor times a block that is symmetric but for rounding.
HWY_INLINE SymmetricLanes upper(Lanes factor, const BlockLanes& b) {
    const Lanes3 x = factor * b.x, y = factor * b.y, z = factor * b.z;
    return {x.x, y.y, z.z, x.y, x.z, y.z};
}

HWY_INLINE BlockLanes load_block(const float* slot) {
    constexpr std::uint32_t next = Stencil::lanes;
    const auto row = [=](const float* at) HWY_ATTR {
        return Lanes3{load_lanes(at), load_lanes(at + next), load_lanes(at + 2 * next)};
    };
    return {row(slot), row(slot + 3 * next), row(slot + 6 * next)};
}
HWY_INLINE void store_block(const BlockLanes& block, float* slot) {
    constexpr std::uint32_t next = Stencil::lanes;
    const auto row = [=](const Lanes3& v, float* at) HWY_ATTR {
        const Tag d;
        hn::Store(v.x, d, at);
        hn::Store(v.y, d, at + next);
        hn::Store(v.z, d, at + 2 * next);
    };
    row(block.x, slot);
    row(block.y, slot + 3 * next);
    row(block.z, slot + 6 * next);
}

/// Adds the block, unless `block` is null, and the force of the sides that end or begin at the particles of
/// `entry` and the next lanes.
HWY_INLINE void add_side(const TriangleState& state, const TriangleSources::Source& source,
                         std::uint32_t entry, BlockLanes* block, Lanes3& force) {
    const Vec4* const rows = state.elements.results.data();
    const std::uint32_t* const sides = &source.sides[entry];
    const auto along = hn::Ne(load_lanes(&source.runs_along[entry]), set(0));
    if (block != nullptr)
        *block = *block + transposed_unless(
                              along, {gather_rows(rows, sides), gather_rows(rows + Stencil::lanes, sides),
                                      gather_rows(rows + 2 * Stencil::lanes, sides)});
    force = force + keep_where(along, gather_rows(rows + 3 * Stencil::lanes, sides));
}

/// sum_j a_ij (position_factor (x_j - x_i) + velocity_factor (v_j - v_i)), with a of quadratic bending.
HWY_INLINE Lanes3 bending_impulse(const TriangleState& state, const TriangleMatrix& matrix, std::uint32_t i,
                                  float position_factor, float velocity_factor) {
    const Stencil& stencil = matrix.scalar_stencil;
    const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
    const Vec4 *const x = state.positions.data(), *const v = state.velocities.data();
    const Lanes3 x_i = xyz(load_rows(x + i)), v_i = xyz(load_rows(v + i));
    Lanes3 by_position = zero3(), by_velocity = by_position;
    for (std::uint32_t s = stencil.group_slots[group]; s < stencil.group_slots[group + 1]; ++s) {
        const Lanes a = load_lanes(&matrix.scalars[s * Stencil::lanes + lane]);
        by_position = mul_add(a, neighbour_rows(stencil, s, lane, x) - x_i, by_position);
        if (velocity_factor != 0)
            by_velocity = mul_add(a, neighbour_rows(stencil, s, lane, v) - v_i, by_velocity);
    }
    return mul_add(set(velocity_factor), by_velocity, set(position_factor) * by_position);
}

// Elements of p particles have K_e <= p diag(K_e), p = 3 for triangles, 6 for the hinges of a triangle
// together: relaxation's diagonal is half of that bound.
constexpr float membrane_part = 1.5f, quadratic_part = 3.0f;

void linearise(const TriangleState& state, LinearisedAbout about, const BlockRange& range,
               TriangleMatrix& matrix, Vec4* right_side) {
    const StepEquation& equation = state.equation;
    const Stencil& stencil = matrix.stencil;
    const bool about_base = about == LinearisedAbout::base, adds = state.additions.impulses.size() > 0;
    const float damping = equation.settings.fabric.damping;
    const float rigidity = equation.gamma * equation.rigidity;
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const Lanes3 v_i = xyz(load_rows(&state.velocities[i]));
        const Row row = external_row(equation, i, load_rows(&state.positions[i]).w, v_i);
        Lanes3 b = row.impulse, force = zero3();
        BlockLanes sum = {force, force, force};
        const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
        for (std::uint32_t s = stencil.group_slots[group]; s < stencil.group_slots[group + 1]; ++s) {
            const std::uint32_t entry = s * Stencil::lanes + lane;
            float* const slot = &matrix.blocks[std::size_t{s} * 9 * Stencil::lanes + lane];
            BlockLanes block = {zero3(), zero3(), zero3()};
            for (const TriangleSources::Source& source : state.sources.sources)
                add_side(state, source, entry, &block, force);
            sum = sum + block;
            if (adds) block = block + load_block(slot);
            if (about_base) b = b + block * (neighbour_rows(stencil, s, lane, state.velocities.data()) - v_i);
            store_block(block, slot);
        }
        b = mul_add(set(equation.gamma), force, b);
        SymmetricLanes diagonal = upper(set(membrane_part), sum);
        if (!state.quadratic.empty()) {
            b = b +
                bending_impulse(state, matrix, i, rigidity, about_base ? matrix.scale : rigidity * damping);
            diagonal = add_identity(
                diagonal, hn::Mul(set(quadratic_part * matrix.scale), load_lanes(&state.quadratic[i])));
        }
        float* const inverse_diagonal =
            &matrix.inverse_diagonal[std::size_t{group} * 6 * Stencil::lanes + lane];
        if (adds) {
            b = b + xyz(load_rows(&state.additions.impulses[i]));
            diagonal =
                diagonal +
                load_symmetric(&state.additions.diagonals[std::size_t{group} * 6 * Stencil::lanes + lane]);
        }
        if (touches(matrix.contacts, i)) diagonal = diagonal + contact_diagonal(*matrix.contacts, i);
        const auto free = hn::Ne(row.row_sum, set(0));
        diagonal = inverse(add_identity(diagonal, row.row_sum), row.row_sum);
        store_rows(keep_where(free, b), row.row_sum, right_side + i);
        hn::Store(row.row_sum, Tag(), &matrix.row_sums[i]);
        store_symmetric(keep_where(free, diagonal), inverse_diagonal);
    }
}

void residual(const TriangleState& state, const BlockRange& range, const TriangleMatrix& matrix,
              Vec4* residual) {
    const StepEquation& equation = state.equation;
    const Stencil& stencil = matrix.stencil;
    const float rigidity = equation.gamma * equation.rigidity;
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const Row row =
            external_row(equation, i, load_rows(&state.positions[i]).w, xyz(load_rows(&state.velocities[i])));
        Lanes3 force = zero3();
        const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
        for (std::uint32_t s = stencil.group_slots[group]; s < stencil.group_slots[group + 1]; ++s)
            for (const TriangleSources::Source& source : state.sources.sources)
                add_side(state, source, s * Stencil::lanes + lane, nullptr, force);
        Lanes3 b = mul_add(set(equation.gamma), force, row.impulse);
        if (!state.quadratic.empty())
            b = b + bending_impulse(state, matrix, i, rigidity, rigidity * equation.settings.fabric.damping);
        if (state.additions.impulses.size() > 0) b = b + xyz(load_rows(&state.additions.impulses[i]));
        store_rows(keep_where(hn::Ne(row.row_sum, set(0)), b), set(0), residual + i);
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // code that does not depend on the machine
namespace weft {

HWY_EXPORT(linearise);
HWY_EXPORT(residual);

TriangleSources::TriangleSources(const ClothModel& model, const TriangleElements& elements,
                                 const Stencil& stencil, const ElementRows& rows) {
    for (Source& source : sources) {
        source.sides = AlignedBuffer<std::uint32_t>(stencil.neighbours.size());
        source.runs_along = AlignedBuffer<float>(stencil.neighbours.size());
        std::ranges::fill(source.sides.span(), elements.zero_side());
    }
    const auto add = [&](std::uint32_t particle, std::uint32_t neighbour, std::uint32_t side, bool along) {
        const std::uint32_t entry = stencil.entry(particle, rows.half_edge(particle, neighbour));
        Source& source = sources[sources[0].sides[entry] == elements.zero_side() ? 0 : 1];
        source.sides[entry] = side;
        source.runs_along[entry] = along ? 1.0f : 0.0f;
    };
    for (std::uint32_t t = 0; t < model.triangles.size(); ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t from = model.triangles[t][k], to = model.triangles[t][(k + 1) % 3];
            add(from, to, TriangleElements::side(t, k), true);
            add(to, from, TriangleElements::side(t, k), false);
        }
    }
}

float TriangleSources::shared_area(const TriangleElements& elements, std::uint32_t entry) const {
    float area = 0;
    for (const Source& source : sources)
        if (const std::uint32_t side = source.sides[entry]; side != elements.zero_side())
            area += elements.area(TriangleElements::triangle_of(side));
    return area;
}

std::size_t TriangleSources::bytes() const noexcept {
    std::size_t sum = 0;
    for (const Source& source : sources) sum += source.sides.bytes() + source.runs_along.bytes();
    return sum;
}

void linearise_block(const TriangleState& state, LinearisedAbout about, const BlockRange& range,
                     TriangleMatrix& matrix, Vec4* right_side) {
    HWY_DYNAMIC_DISPATCH(linearise)(state, about, range, matrix, right_side);
}

void residual_block(const TriangleState& state, const BlockRange& range, const TriangleMatrix& matrix,
                    Vec4* residual) {
    HWY_DYNAMIC_DISPATCH(residual)(state, range, matrix, residual);
}

}  // namespace weft
#endif
