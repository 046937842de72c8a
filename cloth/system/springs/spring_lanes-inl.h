// Springs in registers: how their ends lie, and what a table says of them. Included as
// cloth/system/sparse/stencil-inl.h is.

#if defined(WEFT_CLOTH_SYSTEM_SPRINGS_SPRING_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_CLOTH_SYSTEM_SPRINGS_SPRING_LANES_INL_H
#undef WEFT_CLOTH_SYSTEM_SPRINGS_SPRING_LANES_INL_H
#else
#define WEFT_CLOTH_SYSTEM_SPRINGS_SPRING_LANES_INL_H
#endif

#include "cloth/system/sparse/stencil-inl.h"
#include "cloth/system/springs/membrane.h"
#include "cloth/system/springs/spring_forces.h"
#include "engine/separating_direction.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// spring_terms, lane by lane: the force is stiffness x extension n.
struct Springs {
    Lanes3 direction;  ///< n
    Lanes extension;   ///< [m]
    Lanes per_length;  ///< 1 / length, 0 where ends coincide
    Lanes rest_ratio;  ///< rest length / length
    Lanes stiffness;
};

/// How the ends of springs lie. What waits longest in a row of springs, a root and a division, is in here.
struct Ends {
    Lanes3 separation;
    Lanes squared, length, inverse_length;
};

HWY_INLINE Ends ends_apart(const Lanes3& separation) {
    const Lanes squared = dot(separation, separation), length = hn::Sqrt(squared);
    return {separation, squared, length, hn::Div(set(1), length)};
}

/// The direction (x, y, z), but where the ends coincide, which is rare, one made from their numbers. Of the
/// entries from one on, which are those of the lanes from particle `i` on. By value, so that the loops keep
/// theirs in registers.
template <class Mask>
HWY_NOINLINE Lanes3 with_separating_directions(Lanes x, Lanes y, Lanes z, Mask apart,
                                               const SpringState& state, std::uint32_t entry,
                                               std::uint32_t i) {
    alignas(64) float xs[part_lanes], ys[part_lanes], zs[part_lanes], is_apart[part_lanes];
    const Tag d;
    hn::Store(x, d, xs);
    hn::Store(y, d, ys);
    hn::Store(z, d, zs);
    hn::Store(hn::IfThenElseZero(apart, set(1)), d, is_apart);
    for (std::uint32_t lane = 0; lane < part_lanes; ++lane) {
        if (is_apart[lane] != 0) continue;
        const Vector3 n = separating_direction(state.matrix.neighbour(entry + lane, i + lane), i + lane);
        xs[lane] = n.x();
        ys[lane] = n.y();
        zs[lane] = n.z();
    }
    return {hn::Load(d, xs), hn::Load(d, ys), hn::Load(d, zs)};
}

/// Rest lengths, stiffness and bending of the lanes of an entry.
struct EntryLanes {
    Lanes rest_length, stiffness, bending;
};

/// Where a state has its springs. A kernel's own: through the state they would be looked up anew after each
/// store. `stiffens` is known beforehand, for other springs not to pay for it.
template <bool stiffens>
class SpringTables {
    using SlotKind = SpringTable::SlotKind;

  public:
    HWY_INLINE explicit SpringTables(const SpringState& state)
        : slots_(state.table.slots()),
          rest_lengths_(state.table.rest_lengths()),
          stiffness_(state.table.stiffness()),
          bending_(state.table.bending()),
          shifts_(state.coupling.shifts()),
          sources_(state.coupling.sources()),
          stiffening_(state.table.stiffening()),
          tensions_(state.coupling.extra_tensions()),
          slopes_(state.coupling.extra_stiffness()),
          has_coupling_(!state.coupling.empty()) {}

    [[nodiscard]] HWY_INLINE bool has_springs(std::uint32_t entry) const {
        return slots_[entry / Stencil::lanes].kind < SlotKind::same_bending;
    }
    [[nodiscard]] HWY_INLINE Lanes bending(std::uint32_t entry) const {
        const SpringTable::Slot& slot = slots_[entry / Stencil::lanes];
        return slot.kind == SlotKind::same_bending ? set(slot.entry.bending) : load_lanes(bending_ + entry);
    }
    /// Of the entries from one on, whose slot has springs.
    [[nodiscard]] HWY_INLINE EntryLanes operator[](std::uint32_t entry) const {
        const SpringTable::Slot& slot = slots_[entry / Stencil::lanes];
        if (slot.kind == SlotKind::same && !has_coupling_)
            return {set(slot.entry.rest_length), set(slot.entry.stiffness), set(slot.entry.bending)};
        return {shifted(entry, load_lanes(rest_lengths_ + entry)), load_lanes(stiffness_ + entry),
                load_lanes(bending_ + entry)};
    }

    /// The linear springs that pull as those of an entry do at a length, and as steeply: spring_at() and
    /// TriangleStiffening, lane by lane.
    [[nodiscard]] HWY_INLINE EntryLanes stiffened(std::uint32_t entry, const EntryLanes& of,
                                                  Lanes length) const {
        if constexpr (!stiffens) return of;
        const Lanes least = set(1e-30f);
        if (has_coupling_) {
            const Lanes slope = hn::Add(of.stiffness, of_sides(slopes_, entry));
            const Lanes tension =
                hn::MulAdd(of.stiffness, hn::Sub(length, of.rest_length), of_sides(tensions_, entry));
            // Where ends nearly coincide the pull is cut, to leave the matrix's halves room.
            const Lanes rest =
                hn::Max(hn::Sub(length, hn::Div(tension, hn::Max(slope, least))), hn::Mul(set(-2), length));
            const auto pulls = hn::And(hn::Gt(slope, set(0)), hn::Gt(length, set(1e-12f)));
            return {hn::IfThenElse(pulls, rest, of.rest_length), slope, of.bending};
        }
        const Lanes strain = hn::Sub(hn::Div(length, of.rest_length), set(1));
        const Lanes c = hn::Min(hn::Max(strain, set(0)), set(static_cast<float>(last_stiffening_strain)));
        const Lanes half = hn::Mul(load_lanes(stiffening_ + entry), c);
        const Lanes slope = hn::MulAdd(set(2), half, of.stiffness);
        const Lanes longer = hn::Div(hn::Mul(half, c), hn::Max(slope, least));
        return {hn::MulAdd(of.rest_length, longer, of.rest_length), slope, of.bending};
    }

  private:
    [[nodiscard]] HWY_INLINE Lanes shifted(std::uint32_t entry, Lanes rest_length) const {
        return has_coupling_ ? hn::Add(rest_length, of_sides(shifts_, entry)) : rest_length;
    }
    /// Sums over the two sides of triangles that springs are.
    [[nodiscard]] HWY_INLINE Lanes of_sides(const float* values, std::uint32_t entry) const {
        const hn::RebindToSigned<Tag> numbers;
        const std::uint32_t* const sources =
            sources_ + std::size_t{2} * (entry / Stencil::lanes) * Stencil::lanes + entry % Stencil::lanes;
        const auto source = [&](std::uint32_t k) HWY_ATTR {
            return hn::BitCast(numbers, hn::Load(hn::RebindToUnsigned<Tag>(), sources + k * Stencil::lanes));
        };
        return hn::Add(hn::GatherIndex(Tag(), values, source(0)), hn::GatherIndex(Tag(), values, source(1)));
    }

    const SpringTable::Slot* slots_;
    const float *rest_lengths_, *stiffness_, *bending_, *shifts_;
    const std::uint32_t* sources_;
    const float *stiffening_, *tensions_, *slopes_;  // null: none
    bool has_coupling_;
};

/// Of the entries from one on, which are those of the lanes from particle `i` on.
HWY_INLINE Springs springs_in(const SpringState& state, const EntryLanes& of, std::uint32_t entry,
                              std::uint32_t i, const Ends& ends) {
    const auto& [separation, squared, length, inverse_length] = ends;
    const auto apart = hn::Gt(squared, set(1e-24f));
    Lanes3 direction = keep_where(apart, inverse_length * separation);
    // Where ends coincide there is no spring, mostly.
    if (HWY_UNLIKELY(!hn::AllTrue(Tag(), apart)) &&
        !hn::AllTrue(Tag(), hn::Or(apart, hn::Eq(of.stiffness, set(0)))))
        direction = with_separating_directions(direction.x, direction.y, direction.z, apart, state, entry, i);

    return {direction, hn::Sub(length, of.rest_length), hn::IfThenElseZero(apart, inverse_length),
            hn::Mul(of.rest_length, inverse_length), of.stiffness};
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
