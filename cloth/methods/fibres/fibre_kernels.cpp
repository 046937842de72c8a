#include "cloth/methods/fibres/fibre_kernels.h"

#include "cloth/methods/positional/coincident.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/methods/fibres/fibre_kernels.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/methods/positional/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// The particles of one row of a group's part.
struct RowOfParticles {
    const std::uint32_t* particles;
    Rows start, moved;
    Lanes weights;
};

/// One spring in each lane; where a fibre has ended, direction and violation are 0.
struct Links {
    Lanes compliance;
    Rows apart;     ///< from the row's particles to the next one's [m]
    Lanes inverse;  ///< of the length
    Lanes3 direction;
    Lanes violation;  ///< C + gamma n . (change of apart) [m]
    Lanes weight;     ///< sum of the two particles'
};

HWY_INLINE RowOfParticles particles_of(const FibreGroup& group, std::uint32_t row, std::uint32_t lane) {
    const std::uint32_t at = row * FibreSets::lanes + lane;
    return {group.particles + at, fetch(group.start, group.particles + at),
            fetch(group.moved, group.particles + at), load_lanes(group.weights + at)};
}

/// Moves apart the particles of the row that coincide with their next ones, which is rare.
HWY_NOINLINE void separate_all(const FibreGroup& group, std::uint32_t row, std::uint32_t lane) {
    for (std::uint32_t at = row * FibreSets::lanes + lane; at < row * FibreSets::lanes + lane + part_lanes;
         ++at) {
        const std::uint32_t next = at + FibreSets::lanes;
        if (group.rest_lengths[at] >= 0)
            separate(group.particles[at], group.particles[next], group.weights[at], group.weights[next],
                     group.rest_lengths[at], group.start, group.moved);
    }
}

HWY_INLINE Links links_between(const FibreGroup& group, std::uint32_t row, std::uint32_t lane,
                               RowOfParticles& here, RowOfParticles& next) {
    const Tag tag;
    Links links;
    Rows moved_apart = next.moved - here.moved;
    links.apart = (next.start - here.start) + moved_apart;
    Lanes3 d = lanes_of(links.apart);
    Lanes squared = dot(d, d);
    if (!hn::AllTrue(tag, hn::Gt(squared, hn::Set(tag, coincident)))) {
        put(here.moved, here.particles, group.moved);
        separate_all(group, row, lane);
        here = particles_of(group, row, lane);
        next = particles_of(group, row + 1, lane);
        moved_apart = next.moved - here.moved;
        links.apart = (next.start - here.start) + moved_apart;
        d = lanes_of(links.apart);
        squared = dot(d, d);
    }
    const Lanes rest = load_lanes(group.rest_lengths + row * FibreSets::lanes + lane);
    links.compliance = load_lanes(group.compliances + row * FibreSets::lanes + lane);
    const auto exists = hn::Ge(rest, hn::Zero(tag));
    links.inverse = hn::IfThenElseZero(exists, inverse_length(squared));
    links.direction = links.inverse * d;
    const Lanes stretched_by = dot(links.direction, lanes_of(moved_apart));
    const Lanes violation = hn::MulSub(squared, links.inverse, rest);
    links.violation =
        hn::IfThenElseZero(exists, hn::MulAdd(hn::Set(tag, group.gamma), stretched_by, violation));
    links.weight = hn::Add(here.weights, next.weights);
    return links;
}

// Each spring as in XPBD (Macklin, Mueller, Chentanez 2016, eq. 18 and 26):
//   dlambda = -(C + alpha~ lambda) / (alpha~ + (1 + gamma) (w_a + w_b)).
void gauss_seidel(const FibreGroup& group) {
    const Tag tag;
    const Lanes damped = hn::Set(tag, 1 + group.gamma);
    for (std::uint32_t lane = 0; lane < FibreSets::lanes; lane += part_lanes) {
        RowOfParticles here = particles_of(group, 0, lane);
        for (std::uint32_t row = 0; row < group.rows; ++row) {
            RowOfParticles next = particles_of(group, row + 1, lane);
            const Links links = links_between(group, row, lane, here, next);
            float* const multiplier = group.multipliers + row * FibreSets::lanes + lane;
            const Lanes right = hn::MulAdd(links.compliance, load_lanes(multiplier), links.violation);
            const Lanes change = hn::Neg(hn::Div(right, hn::MulAdd(damped, links.weight, links.compliance)));
            hn::Store(hn::Add(load_lanes(multiplier), change), tag, multiplier);

            const Lanes along = hn::Mul(change, links.inverse);
            put(mul_add(hn::Neg(hn::Mul(along, here.weights)), links.apart, here.moved), here.particles,
                group.moved);
            next.moved = mul_add(hn::Mul(along, next.weights), links.apart, next.moved);
            here = next;
        }
        put(here.moved, here.particles, group.moved);
    }
}

/// The values of a row of springs that LDL^T keeps from its forward to its backward sweep.
struct Kept {
    float* rows;
    [[nodiscard]] HWY_INLINE float* direction(std::uint32_t axis) const {
        return rows + axis * FibreSets::lanes;
    }
    [[nodiscard]] HWY_INLINE float* inverse_pivot() const { return rows + 3 * FibreSets::lanes; }
    [[nodiscard]] HWY_INLINE float* factor() const { return rows + 4 * FibreSets::lanes; }
    [[nodiscard]] HWY_INLINE float* solution() const { return rows + 5 * FibreSets::lanes; }
    [[nodiscard]] HWY_INLINE Lanes3 load_direction() const {
        return {load_lanes(direction(0)), load_lanes(direction(1)), load_lanes(direction(2))};
    }
};
HWY_INLINE Kept kept_of(const FibreGroup& group, std::uint32_t row, std::uint32_t lane) {
    return {group.scratch + std::size_t{row} * FibreGroup::scratch_rows * FibreSets::lanes + lane};
}

/// Factorises, and solves L y = right side. Returns the sum of all violations that are left [m].
HWY_INLINE Lanes factorise(const FibreGroup& group, std::uint32_t lane) {
    const Tag tag;
    const Lanes one = hn::Set(tag, 1.0f), damped = hn::Set(tag, 1 + group.gamma);
    Lanes y = hn::Zero(tag), inverse_pivot = y, violations = y;
    Lanes3 direction = {y, y, y};
    RowOfParticles here = particles_of(group, 0, lane);
    for (std::uint32_t row = 0; row < group.rows; ++row) {
        RowOfParticles next = particles_of(group, row + 1, lane);
        const Links links = links_between(group, row, lane, here, next);
        const Lanes right = hn::Neg(hn::MulAdd(links.compliance,
                                               load_lanes(group.multipliers + row * FibreSets::lanes + lane),
                                               links.violation));
        const Lanes diagonal = hn::MulAdd(damped, links.weight, links.compliance);
        const Lanes beside = hn::Neg(hn::Mul(hn::Mul(damped, here.weights), dot(direction, links.direction)));
        const Lanes factor = hn::Mul(beside, inverse_pivot);
        const Lanes least = hn::Max(links.compliance, hn::Mul(hn::Set(tag, 1e-5f), diagonal));
        inverse_pivot = hn::Div(one, hn::Max(least, hn::NegMulAdd(factor, beside, diagonal)));
        y = hn::NegMulAdd(factor, y, right);
        violations = hn::Add(violations, hn::Abs(right));
        direction = links.direction;

        const Kept kept = kept_of(group, row, lane);
        hn::Store(direction.x, tag, kept.direction(0));
        hn::Store(direction.y, tag, kept.direction(1));
        hn::Store(direction.z, tag, kept.direction(2));
        hn::Store(inverse_pivot, tag, kept.inverse_pivot());
        hn::Store(factor, tag, kept.factor());
        hn::Store(y, tag, kept.solution());
        here = next;
    }
    return violations;
}

/// Solves D L^T dlambda = y in place. Returns the square of the furthest that this would move a particle
/// [m^2].
HWY_INLINE Lanes substitute_back(const FibreGroup& group, std::uint32_t lane) {
    const Tag tag;
    Lanes solution = hn::Zero(tag), factor = solution, furthest = solution;
    Lanes3 pull = {solution, solution, solution};  // of the spring behind the row's, on its first particle
    for (std::uint32_t row = group.rows; row-- > 0;) {
        const Kept kept = kept_of(group, row, lane);
        solution = hn::NegMulAdd(factor, solution,
                                 hn::Mul(load_lanes(kept.solution()), load_lanes(kept.inverse_pivot())));
        factor = load_lanes(kept.factor());
        hn::Store(solution, tag, kept.solution());
        const Lanes3 own_pull = solution * kept.load_direction();
        const Lanes3 move =
            load_lanes(group.weights + (row + 1) * FibreSets::lanes + lane) * (own_pull - pull);
        furthest = hn::Max(furthest, dot(move, move));
        pull = own_pull;
    }
    const Lanes3 move = load_lanes(group.weights + lane) * pull;
    return hn::Max(furthest, dot(move, move));
}

/// u_i += scale w_i (n dlambda of the spring before - n dlambda of the spring behind).
HWY_INLINE void move_particles(const FibreGroup& group, std::uint32_t lane, Lanes scale) {
    const Tag tag;
    Lanes3 before = zero3();
    for (std::uint32_t row = 0; row <= group.rows; ++row) {
        Lanes3 behind = zero3();
        if (row < group.rows) {
            const Kept kept = kept_of(group, row, lane);
            const Lanes change = hn::Mul(scale, load_lanes(kept.solution()));
            float* const multiplier = group.multipliers + row * FibreSets::lanes + lane;
            hn::Store(hn::Add(load_lanes(multiplier), change), tag, multiplier);
            behind = change * kept.load_direction();
        }
        const std::uint32_t at = row * FibreSets::lanes + lane;
        const Lanes3 move = load_lanes(group.weights + at) * (before - behind);
        const std::uint32_t* const particles = group.particles + at;
        put(fetch(group.moved, particles) + rows_of(move), particles, group.moved);
        before = behind;
    }
}

// The fibre's equations J W J^T dlambda = -C with XPBD's compliance and damping,
//   (alpha~ + (1 + gamma) J W J^T) dlambda = -C - alpha~ lambda,
// are tridiagonal: row s has -(1 + gamma) w n_s . n_s+1 beside its diagonal, w of the particle between.
// Two guards apply. No pivot of alpha~ + (a positive semidefinite matrix) is below alpha~, and a pivot below
// 1e-5 of its diagonal is rounding: smaller pivots are raised, which makes that spring more compliant in this
// iteration. No particle needs to move further than the sum of its fibre's violations: where the linearised
// solution would move one further, as along a straight fibre that is pinned at both ends, the whole solution
// is scaled down. Neither guard changes momentum.
void ldlt(const FibreGroup& group) {
    const Tag tag;
    const Lanes one = hn::Set(tag, 1.0f);
    for (std::uint32_t lane = 0; lane < FibreSets::lanes; lane += part_lanes) {
        const Lanes violations = factorise(group, lane);
        const Lanes furthest = substitute_back(group, lane);
        const auto too_far = hn::Gt(furthest, hn::Mul(violations, violations));
        move_particles(group, lane, hn::IfThenElse(too_far, hn::Div(violations, hn::Sqrt(furthest)), one));
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // code that does not depend on the machine
namespace weft {

HWY_EXPORT(gauss_seidel);
HWY_EXPORT(ldlt);

void solve_by_gauss_seidel(const FibreGroup& group) {
    HWY_DYNAMIC_DISPATCH(gauss_seidel)(group);
}

void solve_by_ldlt(const FibreGroup& group) {
    HWY_DYNAMIC_DISPATCH(ldlt)(group);
}

}  // namespace weft
#endif
