#include "cloth/fabric/spring_forces.h"

#include <algorithm>
#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/fabric/spring_forces.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/equation/grid/grid_windows-inl.h"
#include "cloth/fabric/spring_rows-inl.h"
#include "cloth/fabric/springs/membrane.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// Rest lengths and stiffness of the lanes of a place.
struct SpringLanes {
    Lanes rest_length, stiffness;
};

/// TableLanes holds the addresses of a table's lists. Each kernel has its own copy: from the state, the
/// compiler would reload them after each store. `stiffens` is a template parameter, so that linear springs
/// cost no more.
template <bool stiffens>
class TableLanes {
  public:
    HWY_INLINE explicit TableLanes(const SpringTable& table)
        : rest_lengths_(table.rest_lengths()),
          stiffness_(table.stiffness()),
          bending_(table.bending()),
          stiffening_(table.stiffening()) {}

    [[nodiscard]] HWY_INLINE Lanes bending(std::uint32_t entry) const { return load_lanes(bending_ + entry); }
    /// The linear springs that have the tension and slope of the entries' springs at a length: spring_at(),
    /// lane by lane.
    [[nodiscard]] HWY_INLINE SpringLanes springs(std::uint32_t place, Lanes length) const {
        const SpringLanes of{load_lanes(rest_lengths_ + place), load_lanes(stiffness_ + place)};
        if constexpr (!stiffens) return of;
        const Lanes strain = hn::Sub(hn::Div(length, of.rest_length), set(1));
        const Lanes c = hn::Min(hn::Max(strain, set(0)), set(static_cast<float>(last_stiffening_strain)));
        const Lanes half = hn::Mul(load_lanes(stiffening_ + place), c);
        const Lanes slope = hn::MulAdd(set(2), half, of.stiffness);
        const Lanes longer = hn::Div(hn::Mul(half, c), hn::Max(slope, set(1e-30f)));
        return {hn::MulAdd(of.rest_length, longer, of.rest_length), slope};
    }

  private:
    const float *rest_lengths_, *stiffness_, *bending_, *stiffening_;
};

/// A slot of a diagonal, in the lanes from particle `i` on.
struct Slot {
    std::uint32_t number;  ///< index of the diagonal
    std::uint32_t entry;
    std::uint32_t place;  ///< of its springs
    Lanes3 separation;
};

/// A grid's springs. Each particle computes its springs to later ones and passes their shares on to these.
template <bool stiffens, std::uint32_t exchanged>
class SpringsOfGrid {
    static constexpr std::uint32_t position = 0, velocity = 1;  // indices of the loop's vectors

  public:
    HWY_INLINE SpringsOfGrid(const SpringState& state, const BlockRange& range, GridWindow& window)
        : state_(state),
          tables_(state.table),
          diagonals_(state.matrix.diagonals),
          loop_(window, diagonals_, range) {}

    HWY_INLINE void linearise(const Linearisation& equations, const BlockRange& range, SpringMatrix& matrix,
                              Vec4* right_side) {
        // The halo's blocks go here, since its rows are another tile's to store.
        alignas(64) std::uint16_t not_stored[std::size_t{4} * Diagonals::most * Stencil::lanes];
        for (std::uint32_t i = loop_.first(); i < range.end; i += part_lanes, loop_.go_on()) {
            read_ahead();
            const Lanes3 v_i = loop_.own(velocity);
            RowSums sums = no_sums();
            const auto take = [&](std::uint32_t d, const Given& given) HWY_ATTR {
                sums.force = sums.force - given.xyz(0);
                if (matrix.isotropic[d])
                    sums.a = hn::Add(sums.a, given[3]);
                else
                    sums.add({given[6], given.xyz(3)});
            };
            loop_.take_from_far(take);
            std::uint16_t* const coefficients =
                i < range.begin ? not_stored
                                : matrix.coefficients.data() +
                                      matrix.halves_of_diagonal(i / Stencil::lanes, 0) + i % Stencil::lanes;
            const auto halves = [&](const Slot& slot) HWY_ATTR {
                return coefficients + matrix.halves_of_diagonal(0, slot.number);
            };
            const auto bend = [&](const Slot& slot, const Lanes3& v, Lanes3& force) HWY_ATTR {
                if (!equations.has_bending) return set(0);
                const Lanes weight = hn::Mul(set(equations.rigidity), tables_.bending(slot.entry));
                force = mul_add(hn::Mul(set(equations.per_gamma), weight),
                                mul_add(set(equations.ahead()), v, slot.separation), force);
                return hn::Mul(set(1 + equations.viscosity), weight);
            };
            const auto relative = [&](const Slot& slot) HWY_ATTR {
                return equations.uses_velocities ? loop_.later(velocity, slot.number) - v_i : zero3();
            };
            for_each_later(
                i,
                [&](const Slot& slot, const Ends& ends) HWY_ATTR {
                    const Lanes3 v = relative(slot);
                    Lanes3 force = zero3();
                    SpringBlockLanes block =
                        equations.add_force(springs_at(slot, i, ends, equations.elastic), v, force);
                    block.a = hn::Add(block.a, bend(slot, v, force));
                    const SpringBlockLanes stored = store_block(block, halves(slot));
                    loop_.give(slot.number, force.x, force.y, force.z, stored.d.x, stored.d.y, stored.d.z,
                               stored.a);
                    sums.force = sums.force + force;
                    sums.add(stored);
                },
                [&](const Slot& slot) HWY_ATTR {
                    Lanes3 force = zero3();
                    const Lanes a = store_halves(bend(slot, relative(slot), force), halves(slot));
                    loop_.give(slot.number, force.x, force.y, force.z, a);
                    sums.force = sums.force + force;
                    sums.a = hn::Add(sums.a, a);
                });
            if (i < range.begin) continue;
            loop_.take_from_near(take);
            equations.finish(state_, i, v_i, sums, matrix, right_side);
        }
    }

    HWY_INLINE void residual(const BlockRange& range, Vec4* residual) {
        const SpringPulls pulls(state_);
        for (std::uint32_t i = loop_.first(); i < range.end; i += part_lanes, loop_.go_on()) {
            read_ahead();
            const Lanes3 v_i = loop_.own(velocity);
            Lanes3 sum = zero3();
            const auto take = [&sum](std::uint32_t /*d*/, const Given& given)
                                  HWY_ATTR { sum = sum - given.xyz(0); };
            loop_.take_from_far(take);
            const auto relative = [&](const Slot& slot) HWY_ATTR {
                return pulls.damping > 0 ? loop_.later(velocity, slot.number) - v_i : zero3();
            };
            const auto give = [&](const Slot& slot, const Lanes3& v, Lanes3 force) HWY_ATTR {
                if (pulls.has_bending)
                    force = mul_add(hn::Mul(set(pulls.rigidity), tables_.bending(slot.entry)),
                                    mul_add(set(pulls.damping), v, slot.separation), force);
                loop_.give(slot.number, force.x, force.y, force.z);
                sum = sum + force;
            };
            for_each_later(
                i,
                [&](const Slot& slot, const Ends& ends) HWY_ATTR {
                    const Lanes3 v = relative(slot);
                    give(slot, v, pulls.of_springs(springs_at(slot, i, ends, 1), v));
                },
                [&](const Slot& slot) HWY_ATTR { give(slot, relative(slot), zero3()); });
            if (i < range.begin) continue;
            loop_.take_from_near(take);
            finish_residual(state_, i, v_i, sum, residual);
        }
    }

  private:
    HWY_INLINE void read_ahead() {
        loop_.read_ahead([this](std::uint32_t j) HWY_ATTR {
            // The last group reads the padding behind the spans.
            const Lanes3 x = xyz(load_rows(state_.positions.data() + j)),
                         v = xyz(load_rows(state_.velocities.data() + j));
            return std::array<Lanes3, 2>{state_.time_ahead == 0 ? x : mul_add(set(state_.time_ahead), v, x),
                                         v};
        });
    }
    /// The springs of a slot; forces are multiplied by `unit`.
    HWY_INLINE Springs springs_at(const Slot& slot, std::uint32_t i, const Ends& ends, float unit) const {
        const SpringLanes of = tables_.springs(slot.place, ends.length);
        const Lanes stiffness = hn::Mul(set(unit), of.stiffness);
        return springs_between(ends, hn::Mul(stiffness, hn::Sub(ends.length, of.rest_length)), stiffness,
                               state_.matrix, slot.entry, i);
    }
    /// Calls springs(slot, ends) along the diagonals that have springs and bending(slot) along the others, in
    /// the lanes from particle `i` on. The next slot's ends are computed ahead: waiting for one square root
    /// after the other would take half of the time.
    template <class WithSprings, class Bending>
    HWY_INLINE void for_each_later(std::uint32_t i, const WithSprings& springs, const Bending& bending) {
        const Lanes3 x_i = loop_.own(position);
        const std::uint32_t first = diagonals_.entry(i, 0);
        const auto entry = [&](std::uint32_t d) { return first + d * Stencil::lanes; };
        std::uint32_t place = state_.matrix.first_place(i);
        std::uint32_t d = next_with_springs(0);
        Ends next = ends_apart(loop_.later(position, d) - x_i);
        while (d < loop_.diagonals()) {
            const std::uint32_t now = d;
            const Ends ends = next;
            d = next_with_springs(d + 1);
            if (d < loop_.diagonals()) next = ends_apart(loop_.later(position, d) - x_i);
            springs({now, entry(now), place, ends.separation}, ends);
            place += Stencil::lanes;
        }
        for (d = 0; d < loop_.diagonals(); ++d)
            if (state_.matrix.isotropic[d]) bending({d, entry(d), 0, loop_.later(position, d) - x_i});
    }
    /// Returns the first diagonal with springs from `d` on, or diagonals(). Diagonal 0 has springs.
    [[nodiscard]] HWY_INLINE std::uint32_t next_with_springs(std::uint32_t d) const {
        while (d < loop_.diagonals() && state_.matrix.isotropic[d]) ++d;
        return d;
    }

    const SpringState& state_;
    const TableLanes<stiffens> tables_;
    const Diagonals& diagonals_;
    GridLoop<2, exchanged> loop_;
};

void linearise(const SpringState& state, LinearisedAbout about, const BlockRange& range, GridWindow& window,
               SpringMatrix& matrix, Vec4* right_side) {
    const Linearisation equations(state, about);
    if (state.table.stiffening() != nullptr)
        SpringsOfGrid<true, 7>(state, range, window).linearise(equations, range, matrix, right_side);
    else
        SpringsOfGrid<false, 7>(state, range, window).linearise(equations, range, matrix, right_side);
}

void residual(const SpringState& state, const BlockRange& range, GridWindow& window, Vec4* residual) {
    if (state.table.stiffening() != nullptr)
        SpringsOfGrid<true, 3>(state, range, window).residual(range, residual);
    else
        SpringsOfGrid<false, 3>(state, range, window).residual(range, residual);
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // compiled once, not for each instruction set
namespace weft {

HWY_EXPORT(linearise);
HWY_EXPORT(residual);

void linearise_block(const SpringState& state, LinearisedAbout about, const BlockRange& range,
                     GridWindow& window, SpringMatrix& matrix, Vec4* right_side) {
    HWY_DYNAMIC_DISPATCH(linearise)(state, about, range, window, matrix, right_side);
}

void residual_block(const SpringState& state, const BlockRange& range, GridWindow& window, Vec4* residual) {
    HWY_DYNAMIC_DISPATCH(residual)(state, range, window, residual);
}

}  // namespace weft
#endif
