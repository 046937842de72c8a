#include "collision/contact/response/settle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/vector.h"

namespace weft {

namespace {

// Limit of rounds that hold pairs brought too near by rounding: held pairs can bring others too near.
constexpr int most_rounds_of_rounding = 3;

// Fraction of the gap that a pair keeps that must be left after rounding.
constexpr float left_after_rounding = 0.5f;

float gap_along(const Vector3& normal, const FeaturePair& pair, std::uint32_t corners_of_a,
                std::span<const Vec4> positions) {
    const Vector3 origin = xyz(positions[pair.corners[0]]);
    float a = std::numeric_limits<float>::infinity(), b = -a;
    for (std::uint32_t i = 0; i < 4; ++i) {
        const float value = normal.dot(xyz(positions[pair.corners[i]]) - origin);
        if (i < corners_of_a) {
            a = std::min(a, value);
        } else {
            b = std::max(b, value);
        }
    }
    return a - b;
}

}  // namespace

void Settler::lay_out(Scratch& scratch, std::size_t particles, std::size_t bodies, std::size_t pairs) {
    lay_out_split(scratch, particles, bodies);
    lay_out_cut(scratch, particles, bodies, pairs);
}

void Settler::lay_out_split(Scratch& scratch, std::size_t particles, std::size_t bodies) {
    fit_.lay_out(scratch, particles, bodies);
    scratch.take(relative_, particles);
}

void Settler::lay_out_cut(Scratch& scratch, std::size_t particles, std::size_t bodies, std::size_t pairs) {
    scratch.take_by_turns([&] { projection_.lay_out(scratch, particles, pairs); },
                          [&] { truncation_.lay_out(scratch, particles, pairs); });
    scratch.take(ends_, particles);
    scratch.take(held_, pairs);
    const std::size_t blocks = block_count(static_cast<std::uint32_t>(particles)) + bodies;
    scratch.take(partials_, blocks);
    scratch.take(momenta_, blocks);
    scratch.take(failures_, block_count(static_cast<std::uint32_t>(pairs)));
}

void Settler::split(Parallel& parallel, const BodyGroup& group, std::span<const Vec4> displacements,
                    CommonMotionKind most) {
    common_ = most == CommonMotionKind::none
                  ? CommonMotion{}
                  : fit_.fit(parallel, group.particles, group.positions, displacements, most);
    take_out(parallel, common_, group.particles, group.positions, displacements, relative_.span());
}

SettleResult Settler::settle(Parallel& parallel, const BodyGroup& group, const PairList& pairs,
                             std::span<const std::uint8_t> exempt, const TruncationSettings& settings,
                             std::span<Vec4> displacements) {
    SettleResult result;
    truncation_.cut(parallel, group.positions, relative_.span(), pairs, exempt, settings);
    result.sweeps = truncation_.sweeps();
    result.list_was_incomplete = truncation_.list_was_incomplete();
    if (result.list_was_incomplete && group.is_pinned) common_ = CommonMotion{};
    given_back_ = mean_loss(parallel, group, displacements);
    for (int round = 0; pairs.size > 0 && !result.list_was_incomplete; ++round) {
        place_ends(parallel, group, displacements);
        const std::uint32_t to_hold = find_rounded_away(parallel, pairs, result.uncertain);
        if (to_hold == 0 || round == most_rounds_of_rounding) break;
        truncation_.cut_again(parallel, pairs, held_.span(), settings);
        given_back_ = mean_loss(parallel, group, displacements);
        result.sweeps = truncation_.sweeps();
    }
    result.draws_pins = draws_pins(parallel, group, displacements);
    if (result.draws_pins) return result;
    const Totals totals = apply(parallel, group, displacements);
    result.common = common_.kind;
    result.truncated = totals.truncated;
    result.standing_planes = truncation_.standing_planes(parallel, pairs);
    result.motion_lost = totals.wanted > 0 ? static_cast<float>(totals.lost / totals.wanted) : 0;
    return result;
}

Vector3 Settler::mean_loss(Parallel& parallel, const BodyGroup& group, std::span<const Vec4> displacements) {
    if (!group.is_free) return Vector3::Zero();
    const auto find_block = [&](const BlockRange& block) {
        Momentum lost;
        for (std::uint32_t i = block.begin; i < block.end; ++i) {
            const double mass = 1 / double{group.positions[i].w};
            lost.mass += mass;
            const float tau = truncation_.fractions()[i];
            if (tau >= 1) continue;
            const Vector3 wanted = xyz(displacements[i]);
            const Vector3 way = wanted - give_back(common_, xyz(group.positions[i]), wanted, tau);
            for (int axis = 0; axis < 3; ++axis) lost.way[axis] += mass * double{way[axis]};
        }
        return lost;
    };
    const auto add = [](Momentum a, const Momentum& b) {
        a.mass += b.mass;
        for (int axis = 0; axis < 3; ++axis) a.way[axis] += b.way[axis];
        return a;
    };
    const Momentum lost =
        reduce_ranges(parallel, group.particles, momenta_.span(), Momentum{}, find_block, add);
    const Vector3 mean =
        (Eigen::Map<const Eigen::Vector3d>(lost.way) / std::max(lost.mass, 1e-300)).cast<float>();
    return mean.allFinite() ? mean : Vector3::Zero();
}

bool Settler::draws_pins(Parallel& parallel, const BodyGroup& group, std::span<const Vec4> displacements) {
    if (!group.is_pinned || common_.kind == CommonMotionKind::none) return false;
    const auto find_block = [&](const BlockRange& block) {
        Totals farther;
        for (std::uint32_t i = block.begin; i < block.end; ++i) {
            const float tau = truncation_.fractions()[i];
            if (group.positions[i].w > 0 || tau >= 1) continue;
            const Vector3 wanted = xyz(displacements[i]);
            const Vector3 had = give_back(common_, xyz(group.positions[i]), wanted, tau);
            farther.truncated += (wanted - had).norm() > wanted.norm() ? 1 : 0;
        }
        return farther;
    };
    const auto add = [](const Totals& a, const Totals& b) {
        return Totals{.truncated = a.truncated + b.truncated};
    };
    return reduce_ranges(parallel, group.particles, partials_.span(), Totals{}, find_block, add).truncated >
           0;
}

void Settler::place_ends(Parallel& parallel, const BodyGroup& group, std::span<const Vec4> displacements) {
    for_ranges(parallel, group.particles, [&](const BlockRange& block) {
        for (std::uint32_t i = block.begin; i < block.end; ++i) {
            const Vector3 x = xyz(group.positions[i]);
            const float tau = truncation_.fractions()[i];
            set_xyz(ends_[i], x + (give_back(common_, x, xyz(displacements[i]), tau) + given_back_));
        }
    });
}

// Tests the certificate again, at the ends as rounded. Along (A^-1)^T n the map's image of a gap is as wide
// as the gap was along n.
std::uint32_t Settler::find_rounded_away(Parallel& parallel, const PairList& pairs,
                                         std::uint32_t& uncertain) {
    const Matrix3 to_ends = common_.inverse.transpose();
    const auto stands_still = [&](const FeaturePair& pair) {
        return std::ranges::all_of(pair.corners,
                                   [&](std::uint32_t i) { return truncation_.fractions()[i] <= 0; });
    };
    const auto find_block = [&](const BlockRange& block) {
        Failures failures;
        for (std::uint32_t k = block.begin; k < block.end; ++k) {
            held_[k] = 0;
            const float kept = truncation_.kept_gap(k);
            if (!(kept > 0) || truncation_.is_left_out(k)) continue;
            const Vector3 normal = to_ends * xyz(pairs.shapes[k].normal);
            const float gap = gap_along(normal, pairs.pairs[k], pairs.corners_of_a(k), ends_.span());
            if (gap >= left_after_rounding * kept) continue;
            failures.uncertain += gap > 0 ? 0 : 1;
            held_[k] = stands_still(pairs.pairs[k]) ? 0 : 1;
            failures.to_hold += held_[k];
        }
        return failures;
    };
    const auto add = [](const Failures& a, const Failures& b) {
        return Failures{a.to_hold + b.to_hold, a.uncertain + b.uncertain};
    };
    const Failures found = parallel.reduce(pairs.size, failures_.span(), Failures{}, find_block, add);
    uncertain = found.uncertain;
    return found.to_hold;
}

Settler::Totals Settler::apply(Parallel& parallel, const BodyGroup& group, std::span<Vec4> displacements) {
    const auto apply_block = [&](const BlockRange& block) {
        Totals totals;
        for (std::uint32_t i = block.begin; i < block.end; ++i) {
            const Vector3 wanted = xyz(displacements[i]);
            const float length = wanted.norm();
            if (std::isfinite(length)) totals.wanted += double{length};
            const float tau = truncation_.fractions()[i];
            if (tau >= 1 && given_back_.isZero(0)) continue;
            const Vector3 had = give_back(common_, xyz(group.positions[i]), wanted, tau) + given_back_;
            set_xyz(displacements[i], had);
            if (tau >= 1) continue;
            const float lost = (wanted - had).norm();
            ++totals.truncated;
            if (std::isfinite(lost)) totals.lost += double{lost};
        }
        return totals;
    };
    const auto add = [](const Totals& a, const Totals& b) {
        return Totals{a.wanted + b.wanted, a.lost + b.lost, a.truncated + b.truncated};
    };
    return reduce_ranges(parallel, group.particles, partials_.span(), Totals{}, apply_block, add);
}

}  // namespace weft
