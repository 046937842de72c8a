#include "cloth/system/springs/spring_forces.h"

#include <algorithm>
#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/system/springs/spring_forces.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/system/external_row-inl.h"
#include "cloth/system/grid/grid_windows-inl.h"
#include "cloth/system/sparse/stencil-inl.h"
#include "cloth/system/springs/spring_lanes-inl.h"
#include "engine/simd/half_precision-inl.h"
#include "engine/simd/symmetric3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// What springs add up to in rows.
struct RowSums {
    Lanes3 force;  ///< pulls
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
// Springs, and all sums over them, are in the matrix's units: stiffness is gamma^2 k there.
//
// A spring under tension resists turning, whether it is stretched or being stretched: damping's tension
// counts like the elastic one. Without it, iterates about themselves overshoot where damping is stiff, and
// never come to rest. Tension that is negative would make W indefinite, and counts as none (Choi and Ko
// 2002). Bending's Hessian is taken as it is, its negative weights too.
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

    /// Adds what springs pull to `force`; their blocks. relative() is how fast their other ends move.
    template <class Relative>
    HWY_INLINE SpringBlockLanes add_force(const Springs& springs, const Relative& relative,
                                          Lanes3& force) const {
        const Lanes stiffness = hn::Mul(set(elastic), springs.stiffness);
        Lanes slack = springs.rest_ratio;  // 1 - tension / (stiffness x length)
        Lanes push = hn::Mul(stiffness, hn::Mul(set(per_gamma), springs.extension));
        const Lanes viscous = hn::Mul(set(viscosity), stiffness);
        if (about_base) {
            const Lanes axial = hn::Mul(stiffness, hn::Min(set(1), slack));
            const Lanes a = hn::Sub(stiffness, axial);
            const Lanes along = hn::Max(hn::Add(viscous, axial), set(0));
            const Lanes3 v = relative();
            push = hn::MulAdd(along, dot(springs.direction, v), push);
            force = mul_add(push, springs.direction, mul_add(a, v, force));
            return {a, hn::Sqrt(along) * springs.direction};
        }
        if (uses_velocities) {
            const Lanes rate = dot(springs.direction, relative());
            push = hn::MulAdd(viscous, rate, push);
            slack = hn::NegMulAdd(hn::Mul(set(damping), rate), springs.per_length, slack);
        }
        const Lanes along = hn::Max(hn::MulAdd(stiffness, hn::Min(set(1), slack), viscous), set(0));
        force = mul_add(push, springs.direction, force);
        return {hn::Sub(hn::Add(stiffness, viscous), along), hn::Sqrt(along) * springs.direction};
    }

    /// Adds what bending pulls to `force`; its number in W. Of weights by a rigidity of 1.
    template <class Relative>
    HWY_INLINE Lanes add_bending(Lanes weights, const Lanes3& separation, const Relative& relative,
                                 Lanes3& force) const {
        const Lanes weight = hn::Mul(set(rigidity), weights);
        force = mul_add(hn::Mul(set(per_gamma), weight), separation, force);
        const float resisted = about_base ? 1 + viscosity : viscosity;
        if (uses_velocities) force = mul_add(hn::Mul(set(resisted), weight), relative(), force);
        return hn::Mul(set(1 + viscosity), weight);
    }

    /// Rows of W and b, for the lanes from particle `i` on.
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

/// What a residual is made of: forces alone.
struct SpringPulls {
    explicit SpringPulls(const SpringState& state)
        : viscosity(state.equation.settings.fabric.damping),
          rigidity(state.equation.rigidity),
          has_bending(rigidity > 0) {}

    template <class Relative>
    HWY_INLINE Lanes3 of_springs(const Springs& springs, const Relative& relative) const {
        Lanes pull = springs.extension;
        if (viscosity > 0) pull = hn::MulAdd(set(viscosity), dot(springs.direction, relative()), pull);
        return hn::Mul(springs.stiffness, pull) * springs.direction;
    }
    template <class Relative>
    HWY_INLINE Lanes3 of_bending(Lanes weights, const Lanes3& separation, const Relative& relative) const {
        const Lanes3 reach = viscosity > 0 ? mul_add(set(viscosity), relative(), separation) : separation;
        return hn::Mul(set(rigidity), weights) * reach;
    }

    float viscosity, rigidity;
    bool has_bending;
};

HWY_INLINE void finish_residual(const SpringState& state, std::uint32_t i, const Lanes3& v_i,
                                const Lanes3& force, Vec4* residual) {
    const Row row = external_row(state.equation, i, load_rows(&state.positions[i]).w, v_i);
    const auto free = hn::Ne(row.row_sum, set(0));
    store_rows(keep_where(free, mul_add(set(state.equation.gamma), force, row.impulse)), set(0),
               residual + i);
}

/// What a slot holds, in the lanes from particle `i` on.
struct Slot {
    std::uint32_t number;  ///< of the stencil, or the diagonal
    std::uint32_t entry;
    Lanes3 separation;
};

/// Any mesh: each particle looks at all its springs.
template <bool stiffens>
class SpringsOfMesh {
    // Deduced, so before those who use it.
    HWY_INLINE auto relative(std::uint32_t s, std::uint32_t i, const Lanes3& v_i) const {
        return [this, s, i, &v_i]() HWY_ATTR { return velocities_.neighbours(s, i % Stencil::lanes) - v_i; };
    }

  public:
    explicit SpringsOfMesh(const SpringState& state)
        : state_(state),
          tables_(state),
          stencil_(state.matrix.stencil),
          positions_{stencil_, state.positions.data()},
          velocities_{stencil_, state.velocities.data()} {}

    void linearise(const Linearisation& equations, const BlockRange& range, SpringMatrix& matrix,
                   Vec4* right_side) const {
        for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
            const Lanes3 v_i = velocities_.own(i);
            RowSums sums = no_sums();
            const auto add = [&](const Slot& slot, SpringBlockLanes block) HWY_ATTR {
                if (equations.has_bending)
                    block.a =
                        hn::Add(block.a, equations.add_bending(tables_.bending(slot.entry), slot.separation,
                                                               relative(slot.number, i, v_i), sums.force));
                sums.add(store_block(block, &matrix.coefficients[lane_index(slot.entry, 0, 4)]));
            };
            for_each_slot(
                i,
                [&](const Slot& slot, const Springs& springs) HWY_ATTR {
                    add(slot, equations.add_force(springs, relative(slot.number, i, v_i), sums.force));
                },
                [&](const Slot& slot) HWY_ATTR {
                    add(slot, {set(0), zero3()});
                });
            equations.finish(state_, i, v_i, sums, matrix, right_side);
        }
    }

    void residual(const BlockRange& range, Vec4* residual) const {
        const SpringPulls pulls(state_);
        for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
            const Lanes3 v_i = velocities_.own(i);
            Lanes3 force = zero3();
            const auto bend = [&](const Slot& slot) HWY_ATTR {
                if (pulls.has_bending)
                    force = force + pulls.of_bending(tables_.bending(slot.entry), slot.separation,
                                                     relative(slot.number, i, v_i));
            };
            for_each_slot(
                i,
                [&](const Slot& slot, const Springs& springs) HWY_ATTR {
                    force = force + pulls.of_springs(springs, relative(slot.number, i, v_i));
                    bend(slot);
                },
                bend);
            finish_residual(state_, i, v_i, force, residual);
        }
    }

  private:
    /// springs(slot, springs) for the slots of the lanes from particle `i` on that have any, bending(slot)
    /// for the others. The ends of each slot are worked out while the one before is, else a processor would
    /// spend half its time on waiting for one root after the other.
    template <class WithSprings, class Bending>
    HWY_INLINE void for_each_slot(std::uint32_t i, const WithSprings& springs, const Bending& bending) const {
        const std::uint32_t group = i / Stencil::lanes, lane = i % Stencil::lanes;
        const std::uint32_t begin = stencil_.group_slots[group], end = stencil_.group_slots[group + 1];
        if (begin == end) return;
        const Lanes3 x_i = positions_.own(i);
        const auto apart = [&](std::uint32_t s) HWY_ATTR {
            const Lanes3 separation = positions_.neighbours(s, lane) - x_i;
            return tables_.has_springs(s * Stencil::lanes) ? ends_apart(separation)
                                                           : Ends{separation, set(0), set(0), set(0)};
        };
        Ends next = apart(begin);
        for (std::uint32_t s = begin; s < end; ++s) {
            const Ends ends = next;
            if (s + 1 < end) next = apart(s + 1);
            const Slot slot{s, s * Stencil::lanes + lane, ends.separation};
            if (tables_.has_springs(slot.entry))
                springs(slot,
                        springs_in(state_, tables_.stiffened(slot.entry, tables_[slot.entry], ends.length),
                                   slot.entry, i, ends));
            else
                bending(slot);
        }
    }

    const SpringState& state_;
    const SpringTables<stiffens> tables_;
    const Stencil& stencil_;
    RowsInMemory positions_, velocities_;
};

/// A grid: each particle looks at its springs to later ones, and gives these what they have of them.
template <bool stiffens, std::uint32_t exchanged>
class SpringsOfGrid {
    static constexpr std::uint32_t position = 0, velocity = 1;  // of the loop's vectors

    HWY_INLINE auto relative(std::uint32_t d, const Lanes3& v_i) const {
        return [this, d, &v_i]() HWY_ATTR { return loop_.later(velocity, d) - v_i; };
    }

  public:
    HWY_INLINE SpringsOfGrid(const SpringState& state, const BlockRange& range, GridWindow& window)
        : state_(state),
          tables_(state),
          diagonals_(state.matrix.diagonals),
          loop_(window, diagonals_, range) {}

    HWY_INLINE void linearise(const Linearisation& equations, const BlockRange& range, SpringMatrix& matrix,
                              Vec4* right_side) {
        constexpr std::size_t in_slot = 4 * Stencil::lanes;
        alignas(64) std::uint16_t not_stored[Diagonals::most * in_slot];  // in the halo, another tile's
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
                i < range.begin ? not_stored : &matrix.coefficients[lane_index(diagonals_.entry(i, 0), 0, 4)];
            const auto bend = [&](const Slot& slot, Lanes3& force) HWY_ATTR {
                if (!equations.has_bending) return set(0);
                return equations.add_bending(tables_.bending(slot.entry), slot.separation,
                                             relative(slot.number, v_i), force);
            };
            const auto give = [&](const Slot& slot, SpringBlockLanes block, Lanes3 force) HWY_ATTR {
                block.a = hn::Add(block.a, bend(slot, force));
                const SpringBlockLanes stored = store_block(block, coefficients + slot.number * in_slot);
                loop_.give(slot.number, force.x, force.y, force.z, stored.d.x, stored.d.y, stored.d.z,
                           stored.a);
                sums.force = sums.force + force;
                sums.add(stored);
            };
            for_each_later(
                i,
                [&](const Slot& slot, const Springs& springs) HWY_ATTR {
                    Lanes3 force = zero3();
                    const auto block = equations.add_force(springs, relative(slot.number, v_i), force);
                    give(slot, block, force);
                },
                [&](const Slot& slot) HWY_ATTR {
                    Lanes3 force = zero3();
                    const Lanes a = store_halves(bend(slot, force), coefficients + slot.number * in_slot);
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
            const auto give = [&](const Slot& slot, Lanes3 force) HWY_ATTR {
                if (pulls.has_bending)
                    force = force + pulls.of_bending(tables_.bending(slot.entry), slot.separation,
                                                     relative(slot.number, v_i));
                loop_.give(slot.number, force.x, force.y, force.z);
                sum = sum + force;
            };
            for_each_later(
                i,
                [&](const Slot& slot, const Springs& springs)
                    HWY_ATTR { give(slot, pulls.of_springs(springs, relative(slot.number, v_i))); },
                [&](const Slot& slot) HWY_ATTR { give(slot, zero3()); });
            if (i < range.begin) continue;
            loop_.take_from_near(take);
            finish_residual(state_, i, v_i, sum, residual);
        }
    }

  private:
    HWY_INLINE void read_ahead() {
        loop_.read_ahead([this](std::uint32_t j) HWY_ATTR {
            // The last group reads what fills it, behind the spans.
            const Lanes3 x = xyz(load_rows(state_.positions.data() + j)),
                         v = xyz(load_rows(state_.velocities.data() + j));
            return std::array<Lanes3, 2>{state_.time_ahead == 0 ? x : mul_add(set(state_.time_ahead), v, x),
                                         v};
        });
    }
    /// As SpringsOfMesh::for_each_slot, for the diagonals: first those of springs.
    template <class WithSprings, class Bending>
    HWY_INLINE void for_each_later(std::uint32_t i, const WithSprings& springs, const Bending& bending) {
        const Lanes3 x_i = loop_.own(position);
        const std::uint32_t first = diagonals_.entry(i, 0);
        const auto entry = [&](std::uint32_t d) { return first + d * Stencil::lanes; };
        std::uint32_t d = next_with_springs(0);
        Ends next = ends_apart(loop_.later(position, d) - x_i);
        while (d < loop_.diagonals()) {
            const std::uint32_t now = d;
            const Ends ends = next;
            d = next_with_springs(d + 1);
            if (d < loop_.diagonals()) next = ends_apart(loop_.later(position, d) - x_i);
            springs({now, entry(now), ends.separation},
                    springs_in(state_, tables_.stiffened(entry(now), tables_[entry(now)], ends.length),
                               entry(now), i, ends));
        }
        for (d = 0; d < loop_.diagonals(); ++d)
            if (state_.matrix.isotropic[d]) bending({d, entry(d), loop_.later(position, d) - x_i});
    }
    /// From `d` on. There are springs along the first diagonal.
    [[nodiscard]] HWY_INLINE std::uint32_t next_with_springs(std::uint32_t d) const {
        while (d < loop_.diagonals() && state_.matrix.isotropic[d]) ++d;
        return d;
    }

    const SpringState& state_;
    const SpringTables<stiffens> tables_;
    const Diagonals& diagonals_;
    GridLoop<2, exchanged> loop_;
};

template <bool stiffens>
void linearise_springs(const SpringState& state, LinearisedAbout about, const BlockRange& range,
                       GridWindow* window, SpringMatrix& matrix, Vec4* right_side) {
    const Linearisation equations(state, about);
    if (window == nullptr)
        SpringsOfMesh<stiffens>(state).linearise(equations, range, matrix, right_side);
    else
        SpringsOfGrid<stiffens, 7>(state, range, *window).linearise(equations, range, matrix, right_side);
}

template <bool stiffens>
void residual_of_springs(const SpringState& state, const BlockRange& range, GridWindow* window,
                         Vec4* residual) {
    if (window == nullptr)
        SpringsOfMesh<stiffens>(state).residual(range, residual);
    else
        SpringsOfGrid<stiffens, 3>(state, range, *window).residual(range, residual);
}

bool stiffen_at_all(const SpringState& state) {
    return state.table.stiffening() != nullptr || state.coupling.extra_tensions() != nullptr;
}

void linearise(const SpringState& state, LinearisedAbout about, const BlockRange& range, GridWindow* window,
               SpringMatrix& matrix, Vec4* right_side) {
    if (stiffen_at_all(state))
        linearise_springs<true>(state, about, range, window, matrix, right_side);
    else
        linearise_springs<false>(state, about, range, window, matrix, right_side);
}

void residual(const SpringState& state, const BlockRange& range, GridWindow* window, Vec4* residual) {
    if (stiffen_at_all(state))
        residual_of_springs<true>(state, range, window, residual);
    else
        residual_of_springs<false>(state, range, window, residual);
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // what does not depend on the machine
namespace weft {

HWY_EXPORT(linearise);
HWY_EXPORT(residual);

void linearise_block(const SpringState& state, LinearisedAbout about, const BlockRange& range,
                     GridWindow* window, SpringMatrix& matrix, Vec4* right_side) {
    HWY_DYNAMIC_DISPATCH(linearise)(state, about, range, window, matrix, right_side);
}

void residual_block(const SpringState& state, const BlockRange& range, GridWindow* window, Vec4* residual) {
    HWY_DYNAMIC_DISPATCH(residual)(state, range, window, residual);
}

}  // namespace weft
#endif
