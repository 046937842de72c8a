#include "cloth/methods/positional/xpbd_kernel.h"

#include <algorithm>

#include "cloth/methods/positional/coincident.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/methods/positional/xpbd_kernel.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/methods/positional/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// Coincident particles among the springs of a register are rare, and are moved apart one by one.
HWY_NOINLINE void separate_all(const SpringColours& colours, const XpbdSprings& springs, std::uint32_t begin,
                               const Vec4* start, Vec4* moved) {
    for (std::uint32_t s = begin; s < begin + part_lanes; ++s) {
        separate(colours.first[s], colours.second[s], springs.first_weights[s], springs.second_weights[s],
                 springs.rest_lengths[s], start, moved);
    }
}

// Macklin, Mueller, Chentanez 2016, eq. 18 with the damping of eq. 26, for C = |d| - L and alpha~ = 1 / (k
// h^2):
//   dlambda = (-C - alpha~ lambda - gamma n . (u_b - u_a)) / ((1 + gamma) (w_a + w_b) + alpha~),
//   gamma = alpha~ beta~ / h = damping / h,   u_a -= w_a dlambda n,   u_b += w_b dlambda n.
// Multiplied by k h^2 above and below it holds for k = 0, too: see XpbdSolver::find_response.
template <bool damped>
void project(const SpringColours& colours, std::uint32_t begin, std::uint32_t end, float gamma,
             SweepOrder order, XpbdSprings& springs, const Vec4* start, Vec4* moved) {
    const Tag tag;
    for (std::uint32_t s = begin; s < end; s += part_lanes) {
        const std::uint32_t* const first = &colours.first[s];
        const std::uint32_t* const second = &colours.second[s];
        const Rows start_apart = fetch(start, second) - fetch(start, first);
        Rows u_first = fetch(moved, first), u_second = fetch(moved, second);
        Rows moved_apart = u_second - u_first, apart = start_apart + moved_apart;
        Lanes3 d = lanes_of(apart);
        Lanes squared = dot(d, d);
        if (!hn::AllTrue(tag, hn::Gt(squared, hn::Set(tag, coincident)))) {
            separate_all(colours, springs, s, start, moved);
            u_first = fetch(moved, first);
            u_second = fetch(moved, second);
            moved_apart = u_second - u_first;
            apart = start_apart + moved_apart;
            d = lanes_of(apart);
            squared = dot(d, d);
        }

        const Lanes inverse = inverse_length(squared);
        Lanes violation = hn::MulSub(squared, inverse, load_lanes(&springs.rest_lengths[s]));
        if constexpr (damped) {
            const Lanes stretched_by = hn::Mul(inverse, dot(d, lanes_of(moved_apart)));
            violation = hn::MulAdd(hn::Set(tag, gamma), stretched_by, violation);
        }
        Lanes change = hn::Neg(hn::Mul(load_lanes(&springs.responses[s]), violation));
        float* const multiplier = &springs.multipliers[s];
        if (!order.first)
            change = hn::NegMulAdd(load_lanes(&springs.releases[s]), load_lanes(multiplier), change);
        if (!order.last)
            hn::Store(order.first ? change : hn::Add(change, load_lanes(multiplier)), tag, multiplier);

        const Lanes along = hn::Mul(change, inverse);
        put(mul_add(hn::Neg(hn::Mul(along, load_lanes(&springs.first_weights[s]))), apart, u_first), first,
            moved);
        put(mul_add(hn::Mul(along, load_lanes(&springs.second_weights[s])), apart, u_second), second, moved);
    }
}

void project_damped(const SpringColours& colours, std::uint32_t begin, std::uint32_t end, float gamma,
                    SweepOrder order, XpbdSprings& springs, const Vec4* start, Vec4* moved) {
    project<true>(colours, begin, end, gamma, order, springs, start, moved);
}
void project_undamped(const SpringColours& colours, std::uint32_t begin, std::uint32_t end, float gamma,
                      SweepOrder order, XpbdSprings& springs, const Vec4* start, Vec4* moved) {
    project<false>(colours, begin, end, gamma, order, springs, start, moved);
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // code that does not depend on the machine
namespace weft {

HWY_EXPORT(project_damped);
HWY_EXPORT(project_undamped);

namespace {

// Springs are cheap and colours many: smaller blocks cost more to hand out than they save.
constexpr std::uint32_t springs_per_block = 2048;
static_assert(springs_per_block % SpringColours::lanes == 0);

}  // namespace

void sweep_springs(Parallel& parallel, const SpringColours& colours, float gamma, SweepOrder order,
                   XpbdSprings& springs, const Vec4* start, Vec4* moved) {
    for (std::uint32_t c = 0; c < colours.colours(); ++c) {
        const std::uint32_t first = colours.offsets[c], last = colours.offsets[c + 1];
        parallel.blocks((last - first + springs_per_block - 1) / springs_per_block, [&](std::uint32_t block) {
            const std::uint32_t begin = first + block * springs_per_block;
            const std::uint32_t end = std::min(last, begin + springs_per_block);
            if (gamma > 0) {
                HWY_DYNAMIC_DISPATCH(project_damped)
                (colours, begin, end, gamma, order, springs, start, moved);
            } else {
                HWY_DYNAMIC_DISPATCH(project_undamped)
                (colours, begin, end, gamma, order, springs, start, moved);
            }
        });
    }
}

}  // namespace weft
#endif
