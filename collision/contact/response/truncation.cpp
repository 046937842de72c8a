#include "collision/contact/response/truncation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "engine/vector.h"

namespace weft {

namespace {

// Fraction of a gap that counts as kept: rounding then causes no further sweep.
constexpr float tolerance = 0.99f;

// Fraction of its way to the plane that a cut vertex moves, for the same reason. The rest is more than that
// product's rounding: the vertex, rounded to the nearest float, is within its plane, which is a float.
constexpr float short_of_plane = 0.999f;

// Rounding to float changes each of three coordinates on two sides by up to 2^-24 of the largest, and the gap
// by 2e-7 times the largest coordinate. A gap of twice that survives.
constexpr float kept_per_coordinate = 4e-7f;

constexpr std::uint32_t most_rounds_of_standing_planes = 30;

}  // namespace

/// The gap between two sides at given values of tau, and at the start.
struct Truncation::Sides {
    float a0, b0, a, b;

    Sides(const Ways& ways, std::uint32_t corners_of_a, const float* tau) {
        a0 = a = std::numeric_limits<float>::infinity();
        b0 = b = -a;
        for (std::uint32_t i = 0; i < corners_of_a; ++i) {
            a0 = std::min(a0, ways.start[i]);
            a = std::min(a, ways.start[i] + tau[i] * ways.motion[i]);
        }
        for (std::uint32_t i = corners_of_a; i < 4; ++i) {
            b0 = std::max(b0, ways.start[i]);
            b = std::max(b, ways.start[i] + tau[i] * ways.motion[i]);
        }
    }

    /// Planes that A must stay above and B below; the sides share the gap in proportion to their motion.
    void moving_planes(float kept, float& lower_a, float& upper_b) const {
        const float close_a = std::max(0.0f, a0 - a), close_b = std::max(0.0f, b - b0);
        if (close_a > 0 && close_b > 0) {
            const float share = (a0 - b0 - kept) / (close_a + close_b);
            lower_a = a0 - share * close_a;
            upper_b = b0 + share * close_b;
        } else if (close_a > 0) {
            upper_b = b;
            lower_a = b + kept;
        } else {
            lower_a = a;
            upper_b = a - kept;
        }
    }
    void standing_planes(float kept, float& lower_a, float& upper_b) const {
        const float middle = b0 + 0.5f * (a0 - b0);
        lower_a = middle + 0.5f * kept;
        upper_b = middle - 0.5f * kept;
    }
};

void Truncation::lay_out(Scratch& scratch, std::size_t particles, std::size_t pairs) {
    incidence_.lay_out_rows(scratch, particles, pairs);
    scratch.take_by_turns([&] { incidence_.lay_out_build(scratch, pairs); },
                          [&] {
                              scratch.take(limits_, pairs);
                              scratch.take(failed_, pairs);
                          });
    scratch.take(kept_, pairs);
    for (auto* array : {&kinds_, &can_fail_}) scratch.take(*array, pairs);
    scratch.take(was_cut_, particles);
    scratch.take(fractions_, particles);
    scratch.take(block_counts_, block_count(static_cast<std::uint32_t>(pairs)));
}

void Truncation::cut(Parallel& parallel, std::span<const Vec4> positions, std::span<const Vec4> motions,
                     const PairList& pairs, std::span<const std::uint8_t> exempt,
                     const TruncationSettings& settings) {
    sweeps_ = 0;
    incomplete_ = pairs.overflowed || pairs.size > kept_.size();
    const float tau = incomplete_ ? 0.0f : 1.0f;
    parallel.ranges(static_cast<std::uint32_t>(positions.size()), [&](const BlockRange& block) {
        std::fill_n(fractions_.data() + block.begin, block.end - block.begin, tau);
    });
    if (incomplete_ || pairs.size == 0) return;
    positions_ = positions;
    motions_ = motions;
    prepare(parallel, pairs, exempt, settings.floor);
    cut_until_none_fails(parallel, pairs, settings.sweeps);
}

void Truncation::cut_again(Parallel& parallel, const PairList& pairs,
                           std::span<const std::uint8_t> held_pairs, const TruncationSettings& settings) {
    if (incomplete_) return;
    parallel.ranges(pairs.size, [&](const BlockRange& block) {
        for (std::uint32_t k = block.begin; k < block.end; ++k) {
            if (held_pairs[k] != 0) kinds_[k] = held;
        }
    });
    cut_until_none_fails(parallel, pairs, settings.sweeps);
}

Truncation::Ways Truncation::ways_of(const FeaturePair& pair, const PairShape& shape) const {
    const Vector3 normal = xyz(shape.normal), origin = xyz(positions_[pair.corners[0]]);
    Ways ways;
    for (std::uint32_t i = 0; i < 4; ++i) {
        ways.start[i] = normal.dot(xyz(positions_[pair.corners[i]]) - origin);
        ways.motion[i] = normal.dot(xyz(motions_[pair.corners[i]]));
    }
    return ways;
}

Truncation::Kind Truncation::kind_of(const FeaturePair& pair, const PairShape& shape,
                                     std::uint32_t corners_of_a, float floor, float& kept) const {
    const Ways ways = ways_of(pair, shape);
    bool finite = true;
    float lowest_a = std::numeric_limits<float>::infinity(), highest_b = -lowest_a;
    for (std::uint32_t i = 0; i < 4; ++i) {
        finite &= std::isfinite(ways.start[i] + ways.motion[i]);
        if (i < corners_of_a) {
            lowest_a = std::min(lowest_a, ways.start[i] + std::min(0.0f, ways.motion[i]));
        } else {
            highest_b = std::max(highest_b, ways.start[i] + std::max(0.0f, ways.motion[i]));
        }
    }
    constexpr float all[4] = {1, 1, 1, 1};
    const Sides sides(ways, corners_of_a, all);
    kept = 0;
    if (!finite || !(shape.normal.w > 0) || !(sides.a0 > sides.b0)) return held;
    const float farthest = xyz(positions_[pair.corners[0]]).cwiseAbs().maxCoeff();
    kept = std::min(std::max(floor, kept_per_coordinate * farthest), sides.a0 - sides.b0);
    return lowest_a - highest_b >= kept ? at_ease : moving;
}

void Truncation::prepare(Parallel& parallel, const PairList& pairs, std::span<const std::uint8_t> exempt,
                         float floor) {
    parallel.ranges(pairs.size, [&](const BlockRange& block) {
        for (std::uint32_t k = block.begin; k < block.end; ++k) {
            const bool is_exempt = !exempt.empty() && exempt[k] != 0;
            const Kind kind =
                kind_of(pairs.pairs[k], pairs.shapes[k], pairs.corners_of_a(k), floor, kept_[k]);
            kinds_[k] = is_exempt ? left_out : kind;
        }
    });
}

void Truncation::cut_until_none_fails(Parallel& parallel, const PairList& pairs, std::uint32_t most_sweeps) {
    const auto find_block = [&](const BlockRange& block) {
        std::uint32_t count = 0;
        for (std::uint32_t k = block.begin; k < block.end; ++k) {
            can_fail_[k] = kinds_[k] >= moving ? 1 : 0;
            count += can_fail_[k];
        }
        return count;
    };
    if (parallel.reduce(pairs.size, block_counts_.span(), 0u, find_block, std::plus<>()) == 0) return;
    incidence_.build(parallel, pairs.pairs.span().first(pairs.size), can_fail_.span());

    for (std::uint32_t s = 0; s < most_sweeps; ++s) {
        if (sweep(parallel, pairs, Planes::move, s == 0) == 0) return;
    }
    for (std::uint32_t s = 0; s < most_rounds_of_standing_planes; ++s) {
        if (sweep(parallel, pairs, Planes::stand_where_failing, most_sweeps + s == 0) == 0) return;
    }
    sweep(parallel, pairs, Planes::stand, true);
}

/// Cuts the vertices of failing pairs, and returns the number of these pairs.
std::uint32_t Truncation::sweep(Parallel& parallel, const PairList& pairs, Planes planes, bool first) {
    const auto was_cut = [&](std::uint32_t particle) { return was_cut_[particle] != 0; };
    const auto limit_block = [&](const BlockRange& block) {
        std::uint32_t count = 0;
        for (std::uint32_t k = block.begin; k < block.end; ++k) {
            if (can_fail_[k] == 0) continue;
            // A pair without a corner that the last sweep cut holds as before.
            failed_[k] = (first || std::ranges::any_of(pairs.pairs[k].corners, was_cut)) &&
                         limit_pair(pairs, k, planes, limits_[k]);
            count += failed_[k];
        }
        return count;
    };
    ++sweeps_;
    const std::uint32_t failed =
        parallel.reduce(pairs.size, block_counts_.span(), 0u, limit_block, std::plus<>());
    if (failed > 0) gather_limits(parallel);
    return failed;
}

/// Whether the pair fails. `limits` then has the largest tau of its corners: at least one is less than now,
/// so that sweeps make progress, or the pair becomes standing and is done.
bool Truncation::limit_pair(const PairList& pairs, std::uint32_t pair, Planes planes, Limits& limits) {
    const std::array<std::uint32_t, 4>& corners = pairs.pairs[pair].corners;
    const std::uint32_t corners_of_a = pairs.corners_of_a(pair);
    if (kinds_[pair] == held) {
        std::ranges::fill(limits.of, 0.0f);
        return std::ranges::any_of(corners, [&](std::uint32_t i) { return fractions_[i] > 0; });
    }
    if (kinds_[pair] != moving) return false;

    const Ways ways = ways_of(pairs.pairs[pair], pairs.shapes[pair]);
    const float kept = kept_[pair];
    float tau[4];
    for (std::uint32_t i = 0; i < 4; ++i) tau[i] = fractions_[corners[i]];
    const Sides sides(ways, corners_of_a, tau);
    if (planes != Planes::stand && sides.a - sides.b >= tolerance * kept) return false;

    // A corner's value is monotonic in tau, also when rounded: a corner that is within its plane for one tau
    // is so for every smaller one.
    const auto cut_to_planes = [&](float lower_a, float upper_b) {
        lower_a = std::min(lower_a, sides.a0);  // at tau = 0 all are within, whatever the rounding
        upper_b = std::max(upper_b, sides.b0);
        bool any = false;
        for (std::uint32_t i = 0; i < 4; ++i) {
            const float plane = i < corners_of_a ? lower_a : upper_b;
            const auto is_beyond = [&](float t) {
                const float value = ways.start[i] + t * ways.motion[i];
                return i < corners_of_a ? value < plane : value > plane;
            };
            limits.of[i] = 1;
            if (!is_beyond(tau[i])) continue;
            const float most = (plane - ways.start[i]) / ways.motion[i];
            limits.of[i] = short_of_plane * std::clamp(most, 0.0f, tau[i]);
            any = true;
        }
        return any;
    };
    float lower_a, upper_b;
    if (planes == Planes::move) {
        sides.moving_planes(kept, lower_a, upper_b);
        if (cut_to_planes(lower_a, upper_b)) return true;
    }
    sides.standing_planes(kept, lower_a, upper_b);
    kinds_[pair] = standing;
    cut_to_planes(lower_a, upper_b);
    return true;
}

void Truncation::gather_limits(Parallel& parallel) {
    parallel.ranges(incidence_.rows(), [&](const BlockRange& block) {
        for (std::uint32_t row = block.begin; row < block.end; ++row) {
            const std::uint32_t particle = incidence_.particle(row);
            float least = fractions_[particle];
            for (const std::uint32_t place : incidence_.places(row)) {
                if (failed_[place / 4] != 0) least = std::min(least, limits_[place / 4].of[place % 4]);
            }
            was_cut_[particle] = least < fractions_[particle] ? 1 : 0;
            fractions_[particle] = least;
        }
    });
}

std::uint32_t Truncation::standing_planes(Parallel& parallel, const PairList& pairs) {
    if (incomplete_) return 0;
    const auto count_block = [&](const BlockRange& block) {
        std::uint32_t count = 0;
        for (std::uint32_t k = block.begin; k < block.end; ++k) count += kinds_[k] == standing ? 1 : 0;
        return count;
    };
    return parallel.reduce(pairs.size, block_counts_.span(), 0u, count_block, std::plus<>());
}

}  // namespace weft
