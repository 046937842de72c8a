// Rows of the equation from springs in registers, for grids and for rings. Included as
// cloth/equation/sparse/stencil-inl.h is.

#if defined(WEFT_CLOTH_FABRIC_SPRING_ROWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_CLOTH_FABRIC_SPRING_ROWS_INL_H
#undef WEFT_CLOTH_FABRIC_SPRING_ROWS_INL_H
#else
#define WEFT_CLOTH_FABRIC_SPRING_ROWS_INL_H
#endif

#include "cloth/equation/external_row-inl.h"
#include "cloth/equation/sparse/stencil-inl.h"
#include "cloth/fabric/spring_forces.h"
#include "engine/separating_direction.h"
#include "engine/simd/half_precision-inl.h"
#include "engine/simd/symmetric3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// The separation of springs' ends, with its length. The slow operations, a root and a division, are here.
struct Ends {
    Lanes3 separation;
    Lanes squared, length, inverse_length;
};

HWY_INLINE Ends ends_apart(const Lanes3& separation) {
    const Lanes squared = dot(separation, separation), length = hn::Sqrt(squared);
    return {separation, squared, length, hn::Div(set(1), length)};
}

/// Replaces the direction (x, y, z) by one made from the ends' numbers where the ends coincide, which is
/// rare. Lane k is that of entry + k and particle i + k. Arguments are values, so that the loops keep theirs
/// in registers.
template <class Mask>
HWY_NOINLINE Lanes3 with_separating_directions(Lanes x, Lanes y, Lanes z, Mask apart,
                                               const SpringMatrix& matrix, std::uint32_t entry,
                                               std::uint32_t i) {
    alignas(64) float xs[part_lanes], ys[part_lanes], zs[part_lanes], is_apart[part_lanes];
    const Tag d;
    hn::Store(x, d, xs);
    hn::Store(y, d, ys);
    hn::Store(z, d, zs);
    hn::Store(hn::IfThenElseZero(apart, set(1)), d, is_apart);
    for (std::uint32_t lane = 0; lane < part_lanes; ++lane) {
        if (is_apart[lane] != 0) continue;
        const Vector3 n = separating_direction(matrix.neighbour(entry + lane, i + lane), i + lane);
        xs[lane] = n.x();
        ys[lane] = n.y();
        zs[lane] = n.z();
    }
    return {hn::Load(d, xs), hn::Load(d, ys), hn::Load(d, zs)};
}

/// Springs holds the springs of springs.h lane by lane. Tension and stiffness are in units of their row.
struct Springs {
    Lanes3 direction;  ///< n
    Lanes tension;
    Lanes per_length;  ///< 1 / length [1/m], 0 where ends coincide
    Lanes stiffness;
};

/// The springs of the lanes from entry `entry` and particle `i` on.
HWY_INLINE Springs springs_between(const Ends& ends, Lanes tension, Lanes stiffness,
                                   const SpringMatrix& matrix, std::uint32_t entry, std::uint32_t i) {
    const auto apart = hn::Gt(ends.squared, set(1e-24f));
    Lanes3 direction = keep_where(apart, ends.inverse_length * ends.separation);
    // Mostly there is no spring where ends coincide.
    if (HWY_UNLIKELY(!hn::AllTrue(Tag(), apart)) &&
        !hn::AllTrue(Tag(), hn::Or(apart, hn::Eq(stiffness, set(0)))))
        direction =
            with_separating_directions(direction.x, direction.y, direction.z, apart, matrix, entry, i);
    return {direction, tension, hn::IfThenElseZero(apart, ends.inverse_length), stiffness};
}

/// RowSums adds up the springs of each row.
struct RowSums {
    Lanes3 force;  ///< sum of pulls
    Lanes a;
    SymmetricLanes squares;

    HWY_INLINE void add(const SpringBlockLanes& block) {
        a = hn::Add(a, block.a);
        squares = add_square(squares, block.d);
    }
};
HWY_INLINE RowSums no_sums() {
    return {zero3(), set(0), zero_symmetric()};
}

// Kang, eq. 4 and 5, with the springs' damping (c = damping k, along the spring) and the air's taken
// implicitly too:
//   W = M - gamma^2 J - gamma C,  b = M (v_base - v) + gamma (f + gamma J v about the base; f about the
//   iterate).
// Springs, and all sums over them, are in the matrix's units: stiffness and tension are multiplied by
// `elastic`, which is gamma^2 in these units.
//
// A spring under tension resists turning. Damping's tension counts like the elastic one: without it,
// iterations about the iterate overshoot where damping is stiff, and never converge. Negative tension would
// make W indefinite, and counts as none (Choi and Ko 2002). Bending's Hessian is used as it is, with its
// negative weights.
struct Linearisation {
    Linearisation(const SpringState& state, LinearisedAbout about)
        : about_base(about == LinearisedAbout::base),
          damping(state.equation.settings.fabric.damping),
          uses_velocities(about_base || damping > 0),
          squared(state.matrix.unit * state.matrix.unit),
          elastic(state.equation.gamma * state.equation.gamma / squared),
          rigidity(state.equation.rigidity * elastic),
          has_bending(rigidity > 0),
          per_gamma(1 / state.equation.gamma),
          viscosity(damping / state.equation.gamma) {}

    /// Adds the springs' pulls to `force` and returns their blocks. Ends j move at v, relative to ends i.
    HWY_INLINE SpringBlockLanes add_force(const Springs& springs, const Lanes3& v, Lanes3& force) const {
        const Lanes viscous = hn::Mul(set(viscosity), springs.stiffness);
        Lanes push = hn::Mul(set(per_gamma), springs.tension);
        Lanes turning = hn::Mul(springs.tension, springs.per_length);
        if (about_base) {
            // The limit keeps blocks within the range of half precision where ends nearly coincide.
            turning = hn::Min(turning, hn::Mul(set(3), springs.stiffness));
            const Lanes axial = hn::Min(springs.stiffness, hn::Sub(springs.stiffness, turning));
            const Lanes a = hn::Sub(springs.stiffness, axial);
            const Lanes along = hn::Max(hn::Add(viscous, axial), set(0));
            push = hn::MulAdd(along, dot(springs.direction, v), push);
            force = mul_add(push, springs.direction, mul_add(a, v, force));
            return {a, hn::Sqrt(along) * springs.direction};
        }
        if (uses_velocities) {
            const Lanes rate = dot(springs.direction, v);
            push = hn::MulAdd(viscous, rate, push);
            turning = hn::MulAdd(hn::Mul(hn::Mul(set(damping), springs.stiffness), rate), springs.per_length,
                                 turning);
        }
        const Lanes along = hn::Max(
            hn::Add(hn::Min(springs.stiffness, hn::Sub(springs.stiffness, turning)), viscous), set(0));
        force = mul_add(push, springs.direction, force);
        return {hn::Sub(hn::Add(springs.stiffness, viscous), along), hn::Sqrt(along) * springs.direction};
    }

    /// Time by which bending extrapolates positions: gamma about the base, plus the damping [s].
    [[nodiscard]] HWY_INLINE float ahead() const { return (about_base ? 1 / per_gamma : 0) + damping; }

    /// Stores the rows of W and b for the lanes from particle `i` on.
    HWY_INLINE void finish(const SpringState& state, std::uint32_t i, const Lanes3& v_i, const RowSums& sums,
                           SpringMatrix& matrix, Vec4* right_side) const {
        const Row row = external_row(state.equation, i, load_rows(&state.positions[i]).w, v_i);
        const Lanes squared_unit = set(squared);
        const auto free = hn::Ne(row.row_sum, set(0));
        store_rows(keep_where(free, mul_add(squared_unit, sums.force, row.impulse)), row.row_sum,
                   right_side + i);
        hn::Store(row.row_sum, Tag(), &matrix.row_sums[i]);
        SymmetricLanes diagonal =
            add_identity(squared_unit * add_identity(sums.squares, sums.a), row.row_sum);
        if (has_bending) {
            const Lanes excess = load_lanes(&state.bending_excess[i]);
            diagonal = add_identity(diagonal, hn::Mul(set(squared * rigidity * (1 + viscosity)), excess));
        }
        if (touches(matrix.contacts, i)) diagonal = diagonal + contact_diagonal(*matrix.contacts, i);
        store_symmetric(keep_where(free, inverse(diagonal, row.row_sum)),
                        &matrix.inverse_diagonal[lane_index(i, 0, 6)]);
    }

    bool about_base;
    float damping;
    bool uses_velocities;
    float squared, elastic, rigidity;
    bool has_bending;
    float per_gamma, viscosity;
};

/// SpringPulls computes the forces of a residual.
struct SpringPulls {
    explicit SpringPulls(const SpringState& state)
        : damping(state.equation.settings.fabric.damping),
          rigidity(state.equation.rigidity),
          has_bending(rigidity > 0) {}

    /// The pull of springs whose other ends move at v, relative to their own.
    HWY_INLINE Lanes3 of_springs(const Springs& springs, const Lanes3& v) const {
        Lanes pull = springs.tension;
        if (damping > 0)
            pull = hn::MulAdd(hn::Mul(set(damping), springs.stiffness), dot(springs.direction, v), pull);
        return pull * springs.direction;
    }

    float damping, rigidity;
    bool has_bending;
};

HWY_INLINE void finish_residual(const SpringState& state, std::uint32_t i, const Lanes3& v_i,
                                const Lanes3& force, Vec4* residual) {
    const Row row = external_row(state.equation, i, load_rows(&state.positions[i]).w, v_i);
    const auto free = hn::Ne(row.row_sum, set(0));
    store_rows(keep_where(free, mul_add(set(state.equation.gamma), force, row.impulse)), set(0),
               residual + i);
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
