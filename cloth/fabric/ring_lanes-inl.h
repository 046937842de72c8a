// go_round() walks the rings of as many particles as a register has lanes. Included as
// cloth/equation/sparse/stencil-inl.h is.

#if defined(WEFT_CLOTH_FABRIC_RING_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_CLOTH_FABRIC_RING_LANES_INL_H
#undef WEFT_CLOTH_FABRIC_RING_LANES_INL_H
#else
#define WEFT_CLOTH_FABRIC_RING_LANES_INL_H
#endif

#include "cloth/equation/sparse/stencil-inl.h"
#include "cloth/fabric/springs/membrane.h"
#include "cloth/fabric/springs/rings.h"
#include "engine/simd/half_precision-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// RingLanes holds the addresses of the rings of the lanes from one particle on. Each kernel has its own
/// copy: from their owner, the compiler would reload them after each store.
struct RingLanes {
    HWY_INLINE RingLanes(const SpringMatrix& matrix, const Rings& rings, std::uint32_t i)
        : opening(matrix.group_places[i / Stencil::lanes]),
          springs(matrix.springs_of(i / Stencil::lanes)),
          first_slot(matrix.stencil.group_slots[i / Stencil::lanes]),
          slots(matrix.stencil.group_slots[i / Stencil::lanes + 1] - first_slot),
          lane(i % Stencil::lanes),
          first_half(matrix.halves(i / Stencil::lanes, 0) + lane),
          nodes(&matrix.stencil.neighbours[std::size_t{first_slot} * Stencil::lanes + lane]),
          last(rings.last() + i),
          closes(rings.closes() + opening),
          numbers(rings.springs() + std::size_t{opening} * Rings::count * Stencil::lanes + lane),
          stiffening(rings.stiffening() == nullptr
                         ? nullptr
                         : rings.stiffening() +
                               std::size_t{opening} * Rings::stiffening_count * Stencil::lanes + lane) {}

    // Places are numbered within the group; place 0 is the opening.
    [[nodiscard]] HWY_INLINE Lanes number(std::uint32_t place, Rings::Number k) const {
        return load_lanes(numbers + (std::size_t{place} * Rings::count + k) * Stencil::lanes);
    }
    [[nodiscard]] HWY_INLINE Lanes stiffening_number(std::uint32_t place, std::uint32_t k) const {
        return load_lanes(stiffening + (std::size_t{place} * Rings::stiffening_count + k) * Stencil::lanes);
    }
    /// The tension that the place's triangle adds to side a or b without stiffening: by the other side at the
    /// particle and by the third.
    [[nodiscard]] HWY_INLINE Lanes coupled(std::uint32_t place, bool is_a, Lanes other, Lanes third) const;
    [[nodiscard]] HWY_INLINE Lanes3 neighbours(const Vec4* rows, std::uint32_t slot) const {
        return gather_rows(rows, nodes + std::size_t{slot} * Stencil::lanes);
    }
    /// The first half of a slot in the matrix; see SpringMatrix::halves().
    [[nodiscard]] HWY_INLINE std::size_t halves_of(std::uint32_t slot) const {
        return first_half + Stencil::lanes * SpringMatrix::halves_before(slot, springs);
    }
    /// The address of number k of a place in a list of halves that has `count` numbers a place.
    template <class Halves>
    [[nodiscard]] HWY_INLINE Halves* halves(Halves* of_all, std::uint32_t count, std::uint32_t place,
                                            std::uint32_t k) const {
        return of_all + (std::size_t{opening + place} * count + k) * Stencil::lanes + lane;
    }

    std::uint32_t opening, springs;  ///< the group's first place; slots with springs, which come first
    std::uint32_t first_slot, slots, lane;
    std::size_t first_half;  ///< of the matrix's group, in the lane
    const std::uint32_t *nodes, *last;
    const std::uint16_t* closes;
    const float *numbers, *stiffening;
};

/// s a + t b. The two ends of a spring compute the products in either order, so none is fused into the sum.
HWY_INLINE Lanes sum_of_products(Lanes s, Lanes a, Lanes t, Lanes b) {
    return hn::Add(hn::Mul(s, a), hn::Mul(t, b));
}

HWY_INLINE Lanes RingLanes::coupled(std::uint32_t place, bool is_a, Lanes other, Lanes third) const {
    return sum_of_products(number(place, Rings::other), other,
                           number(place, is_a ? Rings::third_a : Rings::third_b), third);
}

/// The stiffening law of a strain, lane by lane; see stiffened().
struct StiffenedLanes {
    Lanes reached;  ///< c, half of the slope
    Lanes tension;  ///< g
};
HWY_INLINE StiffenedLanes stiffened(Lanes strain) {
    const Lanes c = hn::Min(hn::Max(strain, set(0)), set(static_cast<float>(last_stiffening_strain)));
    return {c, hn::Mul(c, hn::Sub(hn::Add(strain, strain), c))};
}

/// Selects `yes` in the lanes whose bit is set and `no` in the others. Bit k is that of lane k.
HWY_INLINE Lanes where_bits(std::uint32_t bits, Lanes yes, Lanes no) {
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits & 255),
                                   static_cast<std::uint8_t>(bits >> 8 & 255)};
    return hn::IfThenElse(hn::LoadMaskBits(Tag(), bytes), yes, no);
}

/// The tension that triangles add to a spring and, if they stiffen, its derivative by the spring's length.
template <bool stiffens>
struct Pull {
    Lanes tension, slope;

    HWY_INLINE static Pull none() { return {set(0), set(0)}; }
    HWY_INLINE friend Pull operator+(const Pull& l, const Pull& r) {
        return {hn::Add(l.tension, r.tension), stiffens ? hn::Add(l.slope, r.slope) : l.slope};
    }
    HWY_INLINE friend Pull where_bits(std::uint32_t bits, const Pull& yes, const Pull& no) {
        return {where_bits(bits, yes.tension, no.tension),
                stiffens ? where_bits(bits, yes.slope, no.slope) : no.slope};
    }
};

/// The numbers of one axis, warp or weft, of a triangle that stiffens, as one of its sides at the particle
/// uses them. Both ends of the side compute the same floats.
struct AxisOfSide {
    Lanes own, other, third;  ///< strain per length of the side, of the other one and of the third
    Lanes modulus;

    HWY_INLINE AxisOfSide(const RingLanes& rings, std::uint32_t place, std::uint32_t axis, bool is_a)
        : own(rings.stiffening_number(place, axis * Rings::axis_count + (is_a ? Rings::by_a : Rings::by_b))),
          other(
              rings.stiffening_number(place, axis * Rings::axis_count + (is_a ? Rings::by_b : Rings::by_a))),
          third(rings.stiffening_number(place, axis * Rings::axis_count + Rings::by_third)),
          modulus(rings.stiffening_number(place, axis * Rings::axis_count + Rings::modulus)) {}

    [[nodiscard]] HWY_INLINE Lanes strain(Lanes own_length, Lanes other_length, Lanes third_length) const {
        return hn::MulAdd(own, own_length, sum_of_products(other, other_length, third, third_length));
    }
    /// The bound of the slope of the side's tension at a clamped strain of its axis.
    [[nodiscard]] HWY_INLINE Lanes own_slope(Lanes reached) const {
        const Lanes size = hn::Abs(own), sum = hn::Add(size, hn::Add(hn::Abs(other), hn::Abs(third)));
        const Lanes bound = hn::Mul(size, hn::Max(size, hn::Mul(set(static_cast<float>(least_bound)), sum)));
        return hn::Mul(hn::Mul(modulus, hn::Add(reached, reached)), bound);
    }
};

/// Goes round the rings of the lanes from a particle on. The `value` of a side is its length, or the change
/// of its length. The visitor has
///   side(place, to the neighbour), third(place, from a's end to b's): return a side and a value
///   open(place, side): receives the side to the last neighbour
///   pull(place, is a, its value, the other's, the third's): returns the triangle's Pull along a or b
///   spring(place, side, pull of both triangles)
/// The next side is computed ahead of a spring: waiting for one square root after the other would take half
/// of the time. The third side is a difference of rows, not of separations: so all three corners compute the
/// same floats.
template <class Visitor>
HWY_INLINE void go_round(const RingLanes& rings, const Vec4* rows, const Lanes3& own, Visitor& visitor) {
    if (rings.springs == 0) return;
    const Lanes3 at_last = gather_rows(rows, rings.last);
    Lanes3 at = rings.neighbours(rows, 0);
    const auto back = visitor.side(0, at_last - own);
    auto side = visitor.side(1, at - own);
    const Lanes across = visitor.third(0, at - at_last);
    visitor.open(0, back);
    auto behind = visitor.pull(0, false, side.value, back.value, across);
    const auto closing = visitor.pull(0, true, back.value, side.value, across);
    for (std::uint32_t place = 1; place <= rings.springs; ++place) {
        const auto now = side;
        const auto from_behind = behind;
        auto ahead = decltype(behind)::none();
        if (place < rings.springs) {
            const Lanes3 next = rings.neighbours(rows, place);
            side = visitor.side(place + 1, next - own);
            const Lanes third = visitor.third(place, next - at);
            ahead = visitor.pull(place, true, now.value, side.value, third);
            behind = visitor.pull(place, false, side.value, now.value, third);
            at = next;
        }
        const std::uint32_t closes = rings.closes[place] >> rings.lane & ((1u << part_lanes) - 1);
        if (HWY_UNLIKELY(closes != 0)) ahead = where_bits(closes, closing, ahead);
        visitor.spring(place, now, from_behind + ahead);
    }
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
