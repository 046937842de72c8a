#include <array>

#include "cloth/fabric/spring_forces.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/fabric/ring_kernels.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/equation/row_loops-inl.h"
#include "cloth/fabric/ring_lanes-inl.h"
#include "cloth/fabric/spring_rows-inl.h"
#include "cloth/fabric/springs/whole_row-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// The matrix W plus the coupling of triangles' sides, at the last linearisation.
struct CoupledMatrix {
    const SpringMatrix& matrix;
    const Rings& rings;
    float elastic;  ///< factor of tensions [s^2]
};

namespace {

/// Visitor of go_round() for forces: the value of a side is its length.
template <bool stiffens>
class LengthsInRings {
  public:
    struct Side {
        Ends ends;
        Lanes value;
    };

    HWY_INLINE LengthsInRings(const SpringState& state, std::uint32_t i)
        : state_(state),
          rings_(state.matrix, state.rings, i),
          i_(i),
          x_(xyz(load_rows(&state.positions[i]))),
          v_(xyz(load_rows(&state.velocities[i]))) {}

    HWY_INLINE Side side(std::uint32_t /*place*/, const Lanes3& separation) const {
        const Ends ends = ends_apart(separation);
        return {ends, ends.length};
    }
    HWY_INLINE Lanes third(std::uint32_t /*place*/, const Lanes3& separation) const {
        return hn::Sqrt(dot(separation, separation));
    }
    HWY_INLINE void open(std::uint32_t /*place*/, const Side& /*last*/) const {}
    HWY_INLINE Pull<stiffens> pull(std::uint32_t place, bool is_a, Lanes own, Lanes other,
                                   Lanes third) const {
        return pull(place, is_a, own, other, third, [](std::uint32_t /*axis*/, Lanes /*reached*/) {});
    }

  protected:
    /// Calls reached(axis, c) with the clamped strain c of each axis, see stiffened().
    template <class Reached>
    HWY_INLINE Pull<stiffens> pull(std::uint32_t place, bool is_a, Lanes own, Lanes other, Lanes third,
                                   const Reached& reached) const {
        Pull<stiffens> result{rings_.coupled(place, is_a, other, third), set(0)};
        for (std::uint32_t k = 0; stiffens && k < 2; ++k) {
            const AxisOfSide axis(rings_, place, k, is_a);
            const Lanes at_zero =
                rings_.stiffening_number(place, k * Rings::axis_count + Rings::strain_at_zero);
            const auto [c, g] = stiffened(hn::Add(axis.strain(own, other, third), at_zero));
            result.tension = hn::MulAdd(hn::Mul(axis.modulus, g), axis.own, result.tension);
            result.slope = hn::Add(result.slope, axis.own_slope(c));
            reached(k, c);
        }
        return result;
    }
    /// The springs of a place; forces are multiplied by `unit`.
    HWY_INLINE Springs springs(std::uint32_t place, const Ends& ends, const Pull<stiffens>& pull,
                               float unit) const {
        Lanes stiffness = rings_.number(place, Rings::stiffness);
        Lanes tension = hn::Add(
            hn::MulSub(rings_.number(place, Rings::slope), ends.length, rings_.number(place, Rings::at_zero)),
            pull.tension);
        if constexpr (stiffens) {
            const Lanes q = rings_.stiffening_number(place, Rings::of_sheet);
            const Lanes per_length = rings_.stiffening_number(place, Rings::per_rest_length);
            const auto [c, g] = stiffened(hn::MulSub(ends.length, per_length, set(1)));
            tension = hn::MulAdd(q, g, tension);
            stiffness = hn::MulAdd(hn::Mul(q, per_length), hn::Add(c, c), hn::Add(stiffness, pull.slope));
        }
        return springs_between(ends, hn::Mul(set(unit), tension), hn::Mul(set(unit), stiffness),
                               state_.matrix, entry(place - 1), i_);
    }
    /// The entry of a slot of the group, in the first of the lanes.
    [[nodiscard]] HWY_INLINE std::uint32_t entry(std::uint32_t slot) const {
        return (rings_.first_slot + slot) * Stencil::lanes + rings_.lane;
    }
    // Positions and velocities of a slot's neighbours, relative to their particles.
    [[nodiscard]] HWY_INLINE Lanes3 separation(std::uint32_t slot) const {
        return rings_.neighbours(state_.positions.data(), slot) - x_;
    }
    [[nodiscard]] HWY_INLINE Lanes3 velocity(std::uint32_t slot) const {
        return rings_.neighbours(state_.velocities.data(), slot) - v_;
    }
    [[nodiscard]] HWY_INLINE Lanes bending(std::uint32_t slot) const {
        return load_lanes(state_.rings.bending() + entry(slot));
    }

    const SpringState& state_;
    const RingLanes rings_;
    std::uint32_t i_;
    const Lanes3 x_, v_;
};

template <bool stiffens>
class Assembly : public LengthsInRings<stiffens> {
    using Base = LengthsInRings<stiffens>;
    using Base::rings_, Base::state_, Base::i_, Base::x_, Base::v_;
    using typename Base::Side;

  public:
    HWY_INLINE Assembly(const SpringState& state, const Linearisation& equations, std::uint32_t i,
                        Rings& rings, SpringMatrix& matrix)
        : Base(state, i), equations_(equations), kept_(rings), matrix_(matrix) {}

    HWY_INLINE void operator()(Vec4* right_side) {
        go_round(rings_, state_.positions.data(), x_, *this);
        for (std::uint32_t slot = rings_.springs; slot < rings_.slots; ++slot) {
            const Lanes a = bend(slot, Base::separation(slot), velocity(slot));
            sums_.a = hn::Add(sums_.a, store_halves(a, coefficients(slot)));
        }
        equations_.finish(state_, i_, v_, sums_, matrix_, right_side);
    }

    HWY_INLINE Lanes third(std::uint32_t place, const Lanes3& separation) const {
        const Lanes length = hn::Sqrt(dot(separation, separation));
        keep_direction(place, 3, hn::Div(set(1), hn::Max(length, set(1e-12f))) * separation);
        return length;
    }
    HWY_INLINE void open(std::uint32_t place, const Side& last) const {
        const auto apart = hn::Gt(last.ends.squared, set(1e-24f));
        keep_direction(place, 0, keep_where(apart, last.ends.inverse_length * last.ends.separation));
    }
    HWY_INLINE Pull<stiffens> pull(std::uint32_t place, bool is_a, Lanes own, Lanes other,
                                   Lanes third) const {
        return Base::pull(place, is_a, own, other, third, [&](std::uint32_t axis, Lanes c) HWY_ATTR {
            store_halves(
                c, rings_.halves(kept_.reached(), Rings::reached_count, place, 2 * axis + (is_a ? 0 : 1)));
        });
    }
    HWY_INLINE void spring(std::uint32_t place, const Side& side, const Pull<stiffens>& pull) {
        const std::uint32_t slot = place - 1;
        const Lanes3 v = velocity(slot);
        const Springs springs = Base::springs(place, side.ends, pull, equations_.elastic);
        SpringBlockLanes block = equations_.add_force(springs, v, sums_.force);
        block.a = hn::Add(block.a, bend(slot, side.ends.separation, v));
        sums_.add(store_block(block, coefficients(slot)));
        keep_direction(place, 0, springs.direction);
    }

  private:
    /// Adds the bending force to the sums. Returns bending's coefficient in W.
    HWY_INLINE Lanes bend(std::uint32_t slot, const Lanes3& separation, const Lanes3& v) {
        if (!equations_.has_bending) return set(0);
        const Lanes weight = hn::Mul(set(equations_.rigidity), Base::bending(slot));
        sums_.force = mul_add(hn::Mul(set(equations_.per_gamma), weight),
                              mul_add(set(equations_.ahead()), v, separation), sums_.force);
        return hn::Mul(set(1 + equations_.viscosity), weight);
    }
    HWY_INLINE Lanes3 velocity(std::uint32_t slot) const {
        return equations_.uses_velocities ? Base::velocity(slot) : zero3();
    }
    HWY_INLINE std::uint16_t* coefficients(std::uint32_t slot) const {
        return matrix_.coefficients.data() + rings_.halves_of(slot);
    }
    HWY_INLINE void keep_direction(std::uint32_t place, std::uint32_t first, const Lanes3& n) const {
        std::uint16_t* const to = rings_.halves(kept_.directions(), Rings::directions_count, place, first);
        store_halves(n.x, to);
        store_halves(n.y, to + Stencil::lanes);
        store_halves(n.z, to + 2 * Stencil::lanes);
    }

    const Linearisation& equations_;
    Rings& kept_;
    SpringMatrix& matrix_;
    RowSums sums_ = no_sums();
};

template <bool stiffens>
class ForcesOfRings : public LengthsInRings<stiffens> {
    using Base = LengthsInRings<stiffens>;
    using Base::rings_, Base::state_, Base::i_, Base::x_, Base::v_;

  public:
    HWY_INLINE ForcesOfRings(const SpringState& state, const SpringPulls& pulls, std::uint32_t i)
        : Base(state, i), pulls_(pulls) {}

    HWY_INLINE void operator()(Vec4* residual) {
        go_round(rings_, state_.positions.data(), x_, *this);
        for (std::uint32_t slot = rings_.springs; pulls_.has_bending && slot < rings_.slots; ++slot)
            bend(slot, Base::separation(slot), velocity(slot));
        finish_residual(state_, i_, v_, force_, residual);
    }

    HWY_INLINE void spring(std::uint32_t place, const typename Base::Side& side, const Pull<stiffens>& pull) {
        const std::uint32_t slot = place - 1;
        const Lanes3 v = velocity(slot);
        force_ = force_ + pulls_.of_springs(Base::springs(place, side.ends, pull, 1), v);
        if (pulls_.has_bending) bend(slot, side.ends.separation, v);
    }

  private:
    HWY_INLINE void bend(std::uint32_t slot, const Lanes3& separation, const Lanes3& v) {
        force_ = mul_add(hn::Mul(set(pulls_.rigidity), Base::bending(slot)),
                         mul_add(set(pulls_.damping), v, separation), force_);
    }
    HWY_INLINE Lanes3 velocity(std::uint32_t slot) const {
        return pulls_.damping > 0 ? Base::velocity(slot) : zero3();
    }

    const SpringPulls& pulls_;
    Lanes3 force_ = zero3();
};

/// Visitor of go_round() for products: the value of a side is the change of its length.
class ChangesInRings {
  public:
    struct Side {
        Lanes3 change, direction;
        Lanes value;
    };

    HWY_INLINE ChangesInRings(const CoupledMatrix& of, std::uint32_t i)
        : of_(of), rings_(of.matrix, of.rings, i), elastic_(of.elastic / (of.matrix.unit * of.matrix.unit)) {}

    /// sum_j A_ij (x_j - x_i) with the coupling, in the matrix's square units.
    HWY_INLINE Lanes3 operator()(const Vec4* x, const Lanes3& own) {
        go_round(rings_, x, own, *this);
        for (std::uint32_t slot = rings_.springs; slot < rings_.slots; ++slot)
            sum_ = mul_add(load_halves(coefficients(slot)), rings_.neighbours(x, slot) - own, sum_);
        return sum_;
    }

    HWY_INLINE Side side(std::uint32_t place, const Lanes3& change) const {
        const Lanes3 n = direction(place, 0);
        return {change, n, dot(n, change)};
    }
    HWY_INLINE Lanes third(std::uint32_t place, const Lanes3& change) const {
        return dot(direction(place, 3), change);
    }
    HWY_INLINE void open(std::uint32_t /*place*/, const Side& /*last*/) const {}
    HWY_INLINE Pull<false> pull(std::uint32_t place, bool is_a, Lanes own, Lanes other, Lanes third) const {
        Lanes tension = rings_.coupled(place, is_a, other, third);
        for (std::uint32_t k = 0; rings_.stiffening != nullptr && k < 2; ++k) {
            const AxisOfSide axis(rings_, place, k, is_a);
            const Lanes c = load_halves(
                rings_.halves(of_.rings.reached(), Rings::reached_count, place, 2 * k + (is_a ? 0 : 1)));
            const Lanes slope = hn::Mul(hn::Mul(axis.modulus, hn::Add(c, c)), axis.own);
            tension = hn::MulAdd(slope, axis.strain(own, other, third), tension);
            tension = hn::NegMulAdd(axis.own_slope(c), own, tension);
        }
        return {tension, set(0)};
    }
    HWY_INLINE void spring(std::uint32_t place, const Side& side, const Pull<false>& pull) {
        const Lanes beyond =
            hn::Sub(rings_.number(place, Rings::slope), rings_.number(place, Rings::stiffness));
        const Lanes tension = hn::MulAdd(beyond, side.value, pull.tension);
        const auto [a, d] = load_block(coefficients(place - 1));
        sum_ = mul_add(a, side.change, sum_);
        sum_ = mul_add(dot(d, side.change), d, sum_);
        sum_ = mul_add(hn::Mul(set(elastic_), tension), side.direction, sum_);
    }

  private:
    HWY_INLINE Lanes3 direction(std::uint32_t place, std::uint32_t first) const {
        const std::uint16_t* const from =
            rings_.halves(of_.rings.directions(), Rings::directions_count, place, first);
        return {load_halves(from), load_halves(from + Stencil::lanes),
                load_halves(from + 2 * Stencil::lanes)};
    }
    HWY_INLINE const std::uint16_t* coefficients(std::uint32_t slot) const {
        return of_.matrix.coefficients.data() + rings_.halves_of(slot);
    }

    const CoupledMatrix& of_;
    const RingLanes rings_;
    float elastic_;
    Lanes3 sum_ = zero3();
};

}  // namespace

/// The row product of multiply_rows(), which finds it by argument-dependent lookup.
HWY_INLINE Lanes3 row_product(const CoupledMatrix& of, std::uint32_t i, const RowsInMemory& x,
                              const Lanes3& x_i) {
    return whole_row(of.matrix, i, x_i, zero3() - ChangesInRings(of, i)(x.rows, x_i));
}

namespace {

template <bool stiffens>
void linearise_as(const SpringState& state, LinearisedAbout about, const BlockRange& range, Rings& rings,
                  SpringMatrix& matrix, Vec4* right_side) {
    const Linearisation equations(state, about);
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes)
        Assembly<stiffens>(state, equations, i, rings, matrix)(right_side);
}
void linearise(const SpringState& state, LinearisedAbout about, const BlockRange& range, Rings& rings,
               SpringMatrix& matrix, Vec4* right_side) {
    const auto kernel = rings.stiffening() != nullptr ? linearise_as<true> : linearise_as<false>;
    kernel(state, about, range, rings, matrix, right_side);
}

template <bool stiffens>
void residual_as(const SpringState& state, const BlockRange& range, Vec4* residual) {
    const SpringPulls pulls(state);
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes)
        ForcesOfRings<stiffens>(state, pulls, i)(residual);
}
void residual(const SpringState& state, const BlockRange& range, Vec4* residual) {
    const auto kernel = state.rings.stiffening() != nullptr ? residual_as<true> : residual_as<false>;
    kernel(state, range, residual);
}

Products multiply(const SpringMatrix& matrix, const Rings& rings, float elastic, const BlockRange& range,
                  const DottedWith& with, const Vec4* x, Vec4* product) {
    RowsInMemory rows{matrix.stencil, x};
    return multiply_rows(CoupledMatrix{matrix, rings, elastic}, range, with, rows, product);
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // compiled once, not for each instruction set
namespace weft {

HWY_EXPORT(linearise);
HWY_EXPORT(residual);
HWY_EXPORT(multiply);

void linearise_rings(const SpringState& state, LinearisedAbout about, const BlockRange& range, Rings& rings,
                     SpringMatrix& matrix, Vec4* right_side) {
    HWY_DYNAMIC_DISPATCH(linearise)(state, about, range, rings, matrix, right_side);
}

void residual_of_rings(const SpringState& state, const BlockRange& range, Vec4* residual) {
    HWY_DYNAMIC_DISPATCH(residual)(state, range, residual);
}

Products multiply_rings(const SpringMatrix& matrix, const Rings& rings, float elastic,
                        const BlockRange& range, const DottedWith& with, const Vec4* x, Vec4* product) {
    return HWY_DYNAMIC_DISPATCH(multiply)(matrix, rings, elastic, range, with, x, product);
}

}  // namespace weft
#endif
