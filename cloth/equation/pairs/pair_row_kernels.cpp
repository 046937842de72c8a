#include "cloth/equation/pairs/pair_row_kernels.h"

#include <algorithm>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/equation/pairs/pair_row_kernels.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "collision/contact/response/leverage.h"
#include "engine/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

static_assert(PairGroup::lanes == group_lanes);

// The depth within which a spring reaches its full stiffness, over the pair's radius.
constexpr float onset_per_radius = 0.1f;
// A second spring begins at this part of the radius, and is so many times as stiff as the first. It carries
// squeezed and strained cloth, whose own springs are a thousand times as stiff as the first. If only the cut
// held that, every step would ask for the same motion again, and the cloth around would tremble.
constexpr float hard_from = 0.5f, hard_per_spring = 30;
// The damper of a pair that does not slide, over the full spring: layers on a slope creep by 0.005 mm/s.
constexpr float stick_per_spring = 10;

HWY_INLINE void store(Lanes v, float* to) {
    hn::Store(v, Tag(), to);
}
HWY_INLINE Lanes3 normal_of(const PairGroup& group, std::uint32_t lane) {
    return {load_lanes(group.normal[0] + lane), load_lanes(group.normal[1] + lane),
            load_lanes(group.normal[2] + lane)};
}

/// The sum of weights times the corners' rows of `vector`.
HWY_INLINE Lanes3 relative(const PairGroup& group, std::uint32_t lane, const Vec4* vector) {
    Lanes3 sum = load_lanes(group.weights[0] + lane) * gather_rows(vector, group.corners[0] + lane);
    for (std::uint32_t c = 1; c < 4; ++c)
        sum = mul_add(load_lanes(group.weights[c] + lane), gather_rows(vector, group.corners[c] + lane), sum);
    return sum;
}

/// Fills in the shapes of the pairs with these numbers.
HWY_INLINE void fill_shapes(const PairShape* shapes, const std::uint32_t* numbers, std::uint32_t count,
                            std::uint32_t lane, PairGroup& group) {
    const auto weights = rows_from(
        [=](std::uint32_t k) HWY_ATTR { return hn::Load(RowTag(), &shapes[numbers[k]].weights.x); });
    const auto normals =
        rows_from([=](std::uint32_t k) HWY_ATTR { return hn::Load(RowTag(), &shapes[numbers[k]].normal.x); });
    const Lanes4 b = lanes4_of(weights);
    const Lanes3 n = lanes_of(normals);
    const auto is_pair = hn::FirstN(Tag(), count > lane ? count - lane : 0);
    store(hn::IfThenElseZero(is_pair, b.x), group.weights[0] + lane);
    store(hn::IfThenElseZero(is_pair, b.y), group.weights[1] + lane);
    store(hn::IfThenElseZero(is_pair, b.z), group.weights[2] + lane);
    store(hn::IfThenElseZero(is_pair, b.w), group.weights[3] + lane);
    store(n.x, group.normal[0] + lane);
    store(n.y, group.normal[1] + lane);
    store(n.z, group.normal[2] + lane);
}

// Differences to the first corner, so that the gap is as exact far from the origin.
HWY_INLINE void fill_gaps(const Vec4* base_positions, std::uint32_t lane, PairGroup& group) {
    const Lanes4 origin = gather_rows_with_w(base_positions, group.corners[0] + lane);
    const Lanes first = load_lanes(group.weights[0] + lane), zero = set(0);
    // mobility_of_gap() in lanes.
    Lanes mobility = zero, most = zero, part = zero;
    const auto add_corner = [&](Lanes b, Lanes inverse_mass) HWY_ATTR {
        const Lanes weight = hn::Abs(b), own = hn::Mul(weight, inverse_mass);
        mobility = hn::MulAdd(hn::Mul(b, b), inverse_mass, mobility);
        most = hn::Max(most, own);
        part = hn::Max(part, hn::IfThenElseZero(hn::Gt(own, zero), weight));
    };
    add_corner(first, origin.w);
    Lanes3 gap = zero3();
    for (std::uint32_t c = 1; c < 4; ++c) {
        const Lanes4 corner = gather_rows_with_w(base_positions, group.corners[c] + lane);
        const Lanes b = load_lanes(group.weights[c] + lane);
        gap = mul_add(b, xyz(corner) - xyz(origin), gap);
        add_corner(b, corner.w);
    }
    mobility = hn::Max(mobility, hn::Mul(most, set(1 / farthest_for_gap)));
    const auto moves = hn::And(hn::Gt(mobility, zero), hn::Ge(part, set(least_of_way)));
    const Lanes mass = hn::Div(set(1), hn::IfThenElse(moves, mobility, set(1)));
    store(hn::IfThenElseZero(moves, mass), group.mass + lane);
    store(dot(normal_of(group, lane), gap), group.gap + lane);
}

void fill(const PairSources& from, const BlockRange& pairs, PairGroup* groups) {
    alignas(64) std::uint32_t numbers[group_lanes];
    for (std::uint32_t k = pairs.begin; k < pairs.end; k += group_lanes) {
        PairGroup& group = groups[k / group_lanes];
        const std::uint32_t count = std::min(group_lanes, pairs.end - k);
        for (std::uint32_t i = 0; i < group_lanes; ++i) {
            numbers[i] = from.numbers[k + std::min(i, count - 1)];
            const PairLaw& law = from.laws[numbers[i]];
            for (std::uint32_t c = 0; c < 4; ++c)
                group.corners[c][i] = from.list->pairs[numbers[i]].corners[c];
            group.radius[i] = i < count ? law.radius : 0;
            group.friction[i] = law.friction;
            group.spring[i] = group.damper[i] = 0;
            group.at_rest[i] = std::numeric_limits<float>::infinity();
        }
        for (std::uint32_t lane = 0; lane < group_lanes; lane += part_lanes) {
            fill_shapes(from.list->shapes.data(), numbers + lane, count, lane, group);
            fill_gaps(from.base_positions, lane, group);
        }
    }
}

/// A spring's stiffness [kg] and its force, over gamma^-2 [kg m].
struct SpringLanes {
    Lanes stiffness, force;
};

/// A spring that begins at depth 0. Up to the onset its force grows with the square of the depth, beyond it
/// linearly.
HWY_INLINE SpringLanes spring_at(Lanes depth, Lanes onset, Lanes full) {
    const auto pushes = hn::Gt(depth, set(0));
    const Lanes part = hn::IfThenElseZero(pushes, hn::Min(hn::Div(depth, onset), set(1)));
    const Lanes stiffness = hn::Mul(full, part);
    return {stiffness, hn::Mul(stiffness, hn::NegMulAdd(hn::Mul(set(0.5f), part), onset, depth))};
}

/// A part's values, one pair to a row.
struct PartShares {
    alignas(64) Vec4 diagonal[part_lanes], off_diagonal[part_lanes], impulse[part_lanes];
};

HWY_INLINE void linearise_part(const PairStiffness& stiffness, const Vec4* velocities, std::uint32_t lane,
                               PairGroup& group, PartShares& shares) {
    const Lanes3 n = normal_of(group, lane), u = relative(group, lane, velocities);
    const Lanes mass = load_lanes(group.mass + lane), friction = load_lanes(group.friction + lane);
    const Lanes along = dot(n, u);
    const Lanes radius = load_lanes(group.radius + lane), onset = hn::Mul(set(onset_per_radius), radius);
    const Lanes depth =
        hn::Sub(radius, hn::MulAdd(set(stiffness.gamma), along, load_lanes(group.gap + lane)));
    const auto pushes = hn::Gt(depth, set(0));
    const Lanes full = hn::IfThenElseZero(pushes, hn::Mul(set(stiffness.spring_per_mass), mass));
    const SpringLanes soft = spring_at(depth, onset, full);
    const SpringLanes hard =
        spring_at(hn::NegMulAdd(set(hard_from), radius, depth), onset, hn::Mul(set(hard_per_spring), full));
    const Lanes spring = hn::Add(soft.stiffness, hard.stiffness);
    const Lanes pressed = hn::Mul(hn::Add(soft.force, hard.force), set(1 / stiffness.gamma));
    const Lanes3 sliding = u - along * n;
    const Lanes speed = hn::Sqrt(dot(sliding, sliding));
    // The impulse by the last pass's linearisation, which balances the load. The springs' own law is convex
    // and gives more wherever a solution is inexact: friction would hold sliding features.
    const Lanes given =
        hn::NegMulAdd(load_lanes(group.spring + lane), along, load_lanes(group.at_rest + lane));
    const Lanes limit = hn::Mul(friction, hn::Min(pressed, hn::Max(given, set(0))));
    const Lanes stick = hn::Mul(set(stick_per_spring), full);
    const auto slides = hn::Lt(limit, hn::Mul(stick, speed));
    const Lanes held = hn::IfThenElse(slides, hn::Div(limit, hn::IfThenElse(slides, speed, set(1))), stick);
    const Lanes damper = hn::IfThenElseZero(hn::Gt(friction, set(0)), held);
    store(hn::MulAdd(spring, along, pressed), group.at_rest + lane);
    store(spring, group.spring + lane);
    store(damper, group.damper + lane);

    const Lanes3 across = hn::Sub(spring, damper) * n;
    const Lanes3 impulse = pressed * n - damper * sliding;
    store_rows({hn::MulAdd(across.x, n.x, damper), hn::MulAdd(across.y, n.y, damper),
                hn::MulAdd(across.z, n.z, damper)},
               spring, shares.diagonal);
    store_rows({hn::Mul(across.x, n.y), hn::Mul(across.x, n.z), hn::Mul(across.y, n.z)}, set(0),
               shares.off_diagonal);
    store_rows(keep_where(pushes, impulse), set(0), shares.impulse);
}

void linearise(const PairStiffness& stiffness, const Vec4* velocities, const BlockRange& pairs,
               PairGroup* groups, PairShare* to) {
    PartShares shares;
    for (std::uint32_t k = pairs.begin; k < pairs.end; k += part_lanes) {
        linearise_part(stiffness, velocities, k % group_lanes, groups[k / group_lanes], shares);
        const std::uint32_t count = std::min(part_lanes, pairs.end - k);
        for (std::uint32_t i = 0; i < count; ++i) {
            to[k + i].diagonal = shares.diagonal[i];
            to[k + i].off_diagonal = shares.off_diagonal[i];
            to[k + i].impulse = shares.impulse[i];
        }
    }
}

HWY_INLINE RowLanes row_of(const Vec4& v) {
    return hn::Load(RowTag(), &v.x);
}

// Whether a listed pair pushes is unpredictable, so there is no branch: shares of pairs that do not push are
// 0, and are added like the others.
std::uint32_t gather(std::span<const std::uint32_t> places, const PairShare* shares, PushedParticle& sum,
                     PushedCorner* pushed) {
    const RowTag d;
    RowLanes diagonal = hn::Zero(d), off_diagonal = hn::Zero(d), impulse = hn::Zero(d);
    std::uint32_t count = 0;
    for (const std::uint32_t place : places) {
        const PairShare& share = shares[place / 4];
        const float weight = (&share.weights.x)[place % 4];
        pushed[count] = {place / 4, weight};
        count += share.diagonal.w > 0 ? 1 : 0;
        const RowLanes b = hn::Set(d, weight), size = hn::Abs(b);
        diagonal = hn::MulAdd(size, row_of(share.diagonal), diagonal);
        off_diagonal = hn::MulAdd(size, row_of(share.off_diagonal), off_diagonal);
        impulse = hn::MulAdd(b, row_of(share.impulse), impulse);
    }
    hn::Store(diagonal, d, &sum.diagonal.x);
    hn::Store(off_diagonal, d, &sum.off_diagonal.x);
    hn::Store(impulse, d, &sum.impulse.x);
    return count;
}

/// Partial sums, one for each of a group's sixteen lanes: the result is the same at any vector width.
double multiply(const Vec4* vector, const BlockRange& pairs, const PairGroup* groups, Vec4* products) {
    constexpr std::uint32_t parts = group_lanes / part_lanes;
    Lanes sums[parts];
    for (Lanes& sum : sums) sum = set(0);
    for (std::uint32_t k = pairs.begin; k < pairs.end; k += group_lanes) {
        const PairGroup& group = groups[k / group_lanes];
        for (std::uint32_t part = 0; part < parts; ++part) {
            const std::uint32_t lane = part * part_lanes;
            const Lanes spring = load_lanes(group.spring + lane), damper = load_lanes(group.damper + lane);
            if (hn::AllFalse(Tag(), hn::Gt(spring, set(0)))) continue;
            const Lanes3 n = normal_of(group, lane), u = relative(group, lane, vector);
            const Lanes3 given = mul_add(hn::Mul(hn::Sub(spring, damper), dot(n, u)), n, damper * u);
            store_rows(given, set(0), products + k + lane);
            sums[part] = hn::Add(sums[part], dot(u, given));
        }
    }
    alignas(64) float all[group_lanes];
    for (std::uint32_t part = 0; part < parts; ++part) store(sums[part], all + part * part_lanes);
    double sum = 0;
    for (const float lane : all) sum += static_cast<double>(lane);
    return sum;
}

void add_to_rows(const PushedRows& rows, const Vec4* products, Vec4* target) {
    const RowTag d;
    for (std::uint32_t r = rows.begin; r < rows.end; ++r) {
        const PushedCorner* corner = rows.corners + rows.starts[r];
        const PushedCorner* const end = corner + rows.counts[r];
        if (corner == end) continue;
        // Two sums, so that an addition waits only for the last but one.
        RowLanes even = hn::Zero(d), odd = hn::Zero(d);
        for (; corner + 1 < end; corner += 2) {
            even = hn::MulAdd(hn::Set(d, corner[0].weight), row_of(products[corner[0].pair]), even);
            odd = hn::MulAdd(hn::Set(d, corner[1].weight), row_of(products[corner[1].pair]), odd);
        }
        if (corner < end) even = hn::MulAdd(hn::Set(d, corner->weight), row_of(products[corner->pair]), even);
        Vec4& to = target[rows.particles[r] - rows.first];
        hn::Store(hn::Add(row_of(to), hn::Add(even, odd)), d, &to.x);
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace weft {

HWY_EXPORT(fill);
HWY_EXPORT(linearise);
HWY_EXPORT(gather);
HWY_EXPORT(multiply);
HWY_EXPORT(add_to_rows);

void fill_groups(const PairSources& from, const BlockRange& pairs, PairGroup* groups) {
    HWY_DYNAMIC_DISPATCH(fill)(from, pairs, groups);
}

void linearise_groups(const PairStiffness& stiffness, const Vec4* velocities, const BlockRange& pairs,
                      PairGroup* groups, PairShare* shares) {
    HWY_DYNAMIC_DISPATCH(linearise)(stiffness, velocities, pairs, groups, shares);
}

std::uint32_t gather_shares(std::span<const std::uint32_t> places, const PairShare* shares,
                            PushedParticle& sum, PushedCorner* pushed) {
    return HWY_DYNAMIC_DISPATCH(gather)(places, shares, sum, pushed);
}

double multiply_groups(const Vec4* vector, const BlockRange& pairs, const PairGroup* groups, Vec4* products) {
    return HWY_DYNAMIC_DISPATCH(multiply)(vector, pairs, groups, products);
}

void add_pushed(const PushedRows& rows, const Vec4* products, Vec4* target) {
    HWY_DYNAMIC_DISPATCH(add_to_rows)(rows, products, target);
}

}  // namespace weft
#endif
