#include "cloth/forces/spring_forces.h"

#include <algorithm>

#include "engine/separating_direction.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/forces/spring_forces.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/forces/halves-inl.h"
#include "cloth/implicit/external_row-inl.h"
#include "cloth/implicit/lanes-inl.h"
#include "cloth/implicit/row_windows-inl.h"
#include "cloth/implicit/symmetric3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// spring_terms, lane by lane: the force is stiffness x extension n, K = (stiffness - axial) I + axial n n^T.
struct Springs {
    Lanes3 direction;  ///< n
    Lanes extension;   ///< [m]
    Lanes stiffness, axial;
};

/// The direction (x, y, z), but where the ends coincide, which is rare, one made from their numbers. By
/// value, so that the loops keep theirs in registers.
template <class Mask>
HWY_NOINLINE Lanes3 with_separating_directions(Lanes x, Lanes y, Lanes z, Mask apart,
                                               const std::uint32_t* neighbours, std::uint32_t i) {
    alignas(64) float xs[part_lanes], ys[part_lanes], zs[part_lanes], is_apart[part_lanes];
    const Tag d;
    hn::Store(x, d, xs);
    hn::Store(y, d, ys);
    hn::Store(z, d, zs);
    hn::Store(hn::IfThenElseZero(apart, set(1)), d, is_apart);
    for (std::uint32_t lane = 0; lane < part_lanes; ++lane) {
        if (is_apart[lane] != 0) continue;
        const Vector3 n = separating_direction(neighbours[lane], i + lane);
        xs[lane] = n.x();
        ys[lane] = n.y();
        zs[lane] = n.z();
    }
    return {hn::Load(d, xs), hn::Load(d, ys), hn::Load(d, zs)};
}

/// Where particles are and how they move, for a loop over rows: from memory,
struct MotionInMemory {
    MotionInMemory(const SpringState& state, const BlockRange& /*range*/, WindowPair* /*windows*/)
        : positions{state.stencil, state.positions.data()},
          velocities{state.stencil, state.velocities.data()} {}
    HWY_INLINE void come_to(std::uint32_t /*i*/) {}

    RowsInMemory positions, velocities;
};

/// or from windows.
struct MotionInWindows {
    MotionInWindows(const SpringState& state, const BlockRange& range, WindowPair* windows)
        : state(state),
          positions(windows->first, state.stencil, range),
          velocities(windows->second, state.stencil, range) {}
    HWY_INLINE void come_to(std::uint32_t i) {
        velocities.come_to(i,
                           [this](std::uint32_t j) HWY_ATTR { return xyz(load_rows(&state.velocities[j])); });
        positions.come_to(i, [this](std::uint32_t j) HWY_ATTR {
            const Lanes3 position = xyz(load_rows(&state.positions[j]));
            return state.time_ahead == 0 ? position : set(state.time_ahead) * velocities.own(j) + position;
        });
    }

    const SpringState& state;
    OpenWindow positions, velocities;
};

/// How the ends of springs lie. What waits longest in a row of springs, a root and a division, is in here.
struct Ends {
    Lanes3 separation;
    Lanes squared, length, inverse_length;
};

/// Of slot s, for the lanes from particle `i` on, which are at x_i.
template <class Motion>
HWY_INLINE Ends ends_in(const Motion& motion, std::uint32_t s, std::uint32_t i, const Lanes3& x_i) {
    const Lanes3 separation = motion.positions.neighbours(s, i % Stencil::lanes) - x_i;
    const Lanes squared = dot(separation, separation), length = hn::Sqrt(squared);
    return {separation, squared, length, hn::Div(set(1), length)};
}

/// Stiffness of each entry of a slot, by kind.
HWY_INLINE Lanes stiffness_in(const SpringState& state, std::uint32_t s, std::uint32_t lane,
                              const SpringStiffness& of_kind) {
    const SpringKinds& kinds = state.kinds;
    if (kinds.of_slots[s] != SpringKinds::mixed) return set(of_kind.values[kinds.of_slots[s]]);
    const Tag d;
    const hn::RebindToSigned<Tag> numbers;
    const hn::Rebind<std::uint8_t, Tag> bytes;
    const auto kind = hn::PromoteTo(numbers, hn::Load(bytes, &kinds.of_entries[s * Stencil::lanes + lane]));
    return hn::TableLookupLanes(hn::Load(d, of_kind.values), hn::IndicesFromVec(d, kind));
}

HWY_INLINE Springs springs_in(const SpringState& state, std::uint32_t s, std::uint32_t i,
                              const SpringStiffness& of_kind, const Ends& ends) {
    const auto& [separation, squared, length, inverse_length] = ends;
    const std::uint32_t entry = s * Stencil::lanes + i % Stencil::lanes;
    const Lanes rest_length = load_lanes(&state.rest_lengths[entry]);
    const Lanes stiffness = stiffness_in(state, s, i % Stencil::lanes, of_kind);

    const auto apart = hn::Gt(squared, set(1e-24f));
    Lanes3 direction = keep_where(apart, inverse_length * separation);
    // Where ends coincide there is no spring, mostly.
    if (HWY_UNLIKELY(!hn::AllTrue(Tag(), apart)) &&
        !hn::AllTrue(Tag(), hn::Or(apart, hn::Eq(stiffness, set(0)))))
        direction = with_separating_directions(direction.x, direction.y, direction.z, apart,
                                               &state.stencil.neighbours[entry], i);

    const Lanes axial = hn::Mul(stiffness, hn::Min(set(1), hn::Mul(rest_length, inverse_length)));
    return {direction, hn::Sub(length, rest_length), stiffness, axial};
}

/// body(s, springs) for the slots of the lanes from particle `i` on. The ends of each slot are worked out
/// while the one before is, else a processor would spend half its time on waiting for one root after the
/// other.
template <class Motion, class Body>
HWY_INLINE void for_each_slot(const SpringState& state, const Motion& motion, std::uint32_t i,
                              const Lanes3& x_i, const SpringStiffness& of_kind, const Body& body) {
    const std::uint32_t group = i / Stencil::lanes;
    const std::uint32_t begin = state.stencil.group_slots[group], end = state.stencil.group_slots[group + 1];
    if (begin == end) return;
    Ends next = ends_in(motion, begin, i, x_i);
    for (std::uint32_t s = begin; s < end; ++s) {
        const Ends ends = next;
        if (s + 1 < end) next = ends_in(motion, s + 1, i, x_i);
        body(s, springs_in(state, s, i, of_kind, ends));
    }
}

// Kang, eq. 4 and 5, with the springs' damping (c = damping k, along the spring) and the air's taken
// implicitly too:
//   W = M - gamma^2 J - gamma C,  b = M (v_base - v) + gamma (f + gamma J v about the base; f about the
//   iterate).
template <class Motion>
void linearise_rows(const SpringState& state, LinearisedAbout about, const BlockRange& range,
                    WindowPair* windows, SpringMatrix& matrix, Vec4* right_side) {
    Motion motion(state, range, windows);
    const bool about_base = about == LinearisedAbout::base;
    const float damping = state.equation.settings.fabric.damping;
    const bool uses_velocities = about_base || damping > 0;
    // Springs, and all sums over them, are in the matrix's units: stiffness is gamma^2 k there.
    const float gamma = state.equation.gamma, squared = matrix.unit * matrix.unit;
    const SpringStiffness of_kind = state.stiffness.times(gamma * gamma / squared);
    const Lanes squared_unit = set(squared), per_gamma = set(1 / gamma), viscosity = set(damping / gamma);

    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        motion.come_to(i);
        const Lanes3 x_i = motion.positions.own(i), v_i = motion.velocities.own(i);
        const Row row = external_row(state.equation, i, load_rows(&state.positions[i]).w, v_i);
        const Lanes zero = set(0);
        Lanes3 b = {zero, zero, zero};
        Lanes sum_of_a = zero;
        SymmetricLanes sum_of_squares = {zero, zero, zero, zero, zero, zero};
        const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
        for_each_slot(state, motion, i, x_i, of_kind, [&](std::uint32_t s, const Springs& springs) {
            const Lanes a = hn::Sub(springs.stiffness, springs.axial);
            const Lanes along = hn::MulAdd(viscosity, springs.stiffness, springs.axial);
            Lanes push = hn::Mul(springs.stiffness, hn::Mul(per_gamma, springs.extension));
            if (uses_velocities) {
                const Lanes3 relative = motion.velocities.neighbours(s, lane) - v_i;
                const Lanes resisted = about_base ? along : hn::Mul(viscosity, springs.stiffness);
                push = hn::MulAdd(resisted, dot(springs.direction, relative), push);
                if (about_base) b = mul_add(a, relative, b);
            }
            b = mul_add(push, springs.direction, b);
            const SpringBlockLanes stored =
                store_block({a, hn::Sqrt(along) * springs.direction},
                            &matrix.coefficients[lane_index(s * Stencil::lanes + lane, 0, 4)]);
            sum_of_a = hn::Add(sum_of_a, stored.a);
            sum_of_squares = add_square(sum_of_squares, stored.d);
        });
        const auto free = hn::Ne(row.row_sum, set(0));
        store_rows(keep_where(free, mul_add(squared_unit, b, row.impulse)), row.row_sum, right_side + i);
        hn::Store(row.row_sum, Tag(), &matrix.row_sums[i]);
        SymmetricLanes diagonal =
            add_identity(squared_unit * add_identity(sum_of_squares, sum_of_a), row.row_sum);
        if (touches(matrix.contacts, i)) diagonal = diagonal + contact_diagonal(*matrix.contacts, i);
        store_symmetric(keep_where(free, inverse(diagonal, row.row_sum)),
                        &matrix.inverse_diagonal[std::size_t{group} * 6 * Stencil::lanes + lane]);
    }
}

template <class Motion>
void residual_rows(const SpringState& state, const BlockRange& range, WindowPair* windows, Vec4* residual) {
    Motion motion(state, range, windows);
    const float damping = state.equation.settings.fabric.damping;
    const Lanes gamma = set(state.equation.gamma), viscosity = set(damping);
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        motion.come_to(i);
        const Lanes3 x_i = motion.positions.own(i), v_i = motion.velocities.own(i);
        const Row row = external_row(state.equation, i, load_rows(&state.positions[i]).w, v_i);
        Lanes3 force = {set(0), set(0), set(0)};
        const std::uint32_t lane = i % Stencil::lanes;
        for_each_slot(state, motion, i, x_i, state.stiffness, [&](std::uint32_t s, const Springs& springs) {
            Lanes pull = springs.extension;
            if (damping > 0) {
                const Lanes3 relative = motion.velocities.neighbours(s, lane) - v_i;
                pull = hn::MulAdd(viscosity, dot(springs.direction, relative), pull);
            }
            const Lanes push = hn::Mul(springs.stiffness, pull);
            force = mul_add(push, springs.direction, force);
        });
        const auto free = hn::Ne(row.row_sum, set(0));
        store_rows(keep_where(free, mul_add(gamma, force, row.impulse)), set(0), residual + i);
    }
}

void linearise(const SpringState& state, LinearisedAbout about, const BlockRange& range, WindowPair* windows,
               SpringMatrix& matrix, Vec4* right_side) {
    const auto rows = windows == nullptr ? linearise_rows<MotionInMemory> : linearise_rows<MotionInWindows>;
    rows(state, about, range, windows, matrix, right_side);
}

void residual(const SpringState& state, const BlockRange& range, WindowPair* windows, Vec4* residual) {
    const auto rows = windows == nullptr ? residual_rows<MotionInMemory> : residual_rows<MotionInWindows>;
    rows(state, range, windows, residual);
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // what does not depend on the machine
namespace weft {

HWY_EXPORT(linearise);
HWY_EXPORT(residual);

SpringKinds::SpringKinds(const Stencil& stencil, std::span<const SpringKind> of_half_edges)
    : of_entries(stencil.neighbours.size()), of_slots(stencil.slots()) {
    std::ranges::fill(of_entries.span(), none);
    for (std::size_t e = 0; e < of_half_edges.size(); ++e)
        of_entries[stencil.entries[e]] = static_cast<std::uint8_t>(of_half_edges[e]);
    for (std::uint32_t s = 0; s < stencil.slots(); ++s) {
        const auto slot = of_entries.span().subspan(s * Stencil::lanes, Stencil::lanes);
        const bool all = slot[0] != none && std::ranges::count(slot, slot[0]) == Stencil::lanes;
        of_slots[s] = all ? slot[0] : mixed;
    }
}

void linearise_block(const SpringState& state, LinearisedAbout about, const BlockRange& range,
                     WindowPair* windows, SpringMatrix& matrix, Vec4* right_side) {
    HWY_DYNAMIC_DISPATCH(linearise)(state, about, range, windows, matrix, right_side);
}

void residual_block(const SpringState& state, const BlockRange& range, WindowPair* windows, Vec4* residual) {
    HWY_DYNAMIC_DISPATCH(residual)(state, range, windows, residual);
}

}  // namespace weft
#endif
