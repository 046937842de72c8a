#pragma once
// Truncation: cuts each particle's motion so that no pair of features meets. Divide and truncate (planes
// between the sides of pairs, arXiv 2604.15513, 2026), with planes that move where they can (ours).
//
// The certificate of a pair with unit normal n at x; particle i moves the fraction tau_i of its motion E_i:
//     a(s) = min over A of n . (x_i + s tau_i E_i),    b(s) = max over B of n . (x_j + s tau_j E_j),
// for s from 0, the start, to 1, the end. If a > b, a plane across n separates the sides, and they do not
// meet. Each n . x_i(s) is linear in s. The least of linear functions is concave, and so is minus the
// greatest: the gap a - b is concave, and nowhere less than the smaller of its two ends. A gap of at least
// eps at both ends is thus one all the way, and only the end has to be tested: no other time, no other
// direction, no root of a cubic.
//
// If the end fails, only the vertices that close the gap are cut: the rest of the gap is shared in the ratio
// in which the sides close it. A cut vertex may make another pair fail, hence sweeps. A pair that keeps
// failing gets a plane that stands still in the middle of its gap, with A on one side and B on the other:
// further cuts leave that true. After a bounded number of rounds no pair fails.

#include <cstdint>
#include <span>

#include "collision/contact/pairs/incidence.h"
#include "collision/contact/pairs/pairs.h"
#include "engine/memory/scratch.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

struct TruncationSettings {
    /// Least gap that a pair keeps [m]; a pair that starts with a smaller gap keeps that one. Rounding at the
    /// end of the step must not close it: where coordinates are so large that it could, more is kept.
    float floor = 1e-5f;
    std::uint32_t sweeps = 30;  ///< sweeps before planes stand still
};

class Truncation {
  public:
    void lay_out(Scratch& scratch, std::size_t particles, std::size_t pairs);

    /// Finds tau. Each pair keeps a gap of min(floor, gap at the start), except those that are exempt
    /// (exempt[pair] != 0; may be empty). Corners of other pairs without a positive gap do not move, nor do
    /// those of a pair with a value that is not finite. Pinned particles are cut like all others.
    /// Preconditions: the list holds all pairs that these motions bring nearer than the floor (E, without
    /// common motion: PairFinder::find with motions = E). If it is incomplete (overflowed, or more pairs than
    /// reserved for), tau is 0 for all. Spans are of all bodies' particles.
    void cut(Parallel& parallel, std::span<const Vec4> positions, std::span<const Vec4> motions,
             const PairList& pairs, std::span<const std::uint8_t> exempt, const TruncationSettings& settings);

    /// Holds the corners of pairs that the caller found to fail by rounding: cut() again, with tau = 0 there.
    /// held_pairs[pair] != 0 says which. Precondition: after cut(), with the same arguments, none of which
    /// has changed.
    void cut_again(Parallel& parallel, const PairList& pairs, std::span<const std::uint8_t> held_pairs,
                   const TruncationSettings& settings);

    /// tau of every particle, 0 to 1.
    [[nodiscard]] std::span<const float> fractions() const noexcept { return fractions_.span(); }
    /// The gap that the pair keeps [m], 0 without one at the start; without meaning for pairs left out.
    [[nodiscard]] float kept_gap(std::uint32_t pair) const noexcept { return kept_[pair]; }
    /// Whether a pair was left out.
    [[nodiscard]] bool is_left_out(std::uint32_t pair) const noexcept { return kinds_[pair] == left_out; }

    [[nodiscard]] bool list_was_incomplete() const noexcept { return incomplete_; }
    [[nodiscard]] std::uint32_t sweeps() const noexcept { return sweeps_; }
    [[nodiscard]] std::uint32_t standing_planes(Parallel& parallel, const PairList& pairs);

  private:
    /// Positions from the first corner and motions of a pair's corners, along the pair's normal.
    struct Ways {
        float start[4], motion[4];  // n . x and n . E of its corners [m]
    };
    struct Limits {
        float of[4];  // the largest tau of each corner
    };
    enum Kind : std::uint8_t {
        at_ease,   // keeps its gap whatever tau is
        left_out,  // exempt
        moving,    // its plane may move
        standing,  // its plane stands still
        held,      // its corners do not move
    };
    struct Sides;

    [[nodiscard]] Ways ways_of(const FeaturePair& pair, const PairShape& shape) const;
    void prepare(Parallel& parallel, const PairList& pairs, std::span<const std::uint8_t> exempt,
                 float floor);
    /// The pair's kind. `kept` becomes the gap that the pair must keep [m].
    [[nodiscard]] Kind kind_of(const FeaturePair& pair, const PairShape& shape, std::uint32_t corners_of_a,
                               float floor, float& kept) const;
    void cut_until_none_fails(Parallel& parallel, const PairList& pairs, std::uint32_t most_sweeps);
    enum class Planes : std::uint8_t { move, stand_where_failing, stand };
    std::uint32_t sweep(Parallel& parallel, const PairList& pairs, Planes planes, bool first);
    bool limit_pair(const PairList& pairs, std::uint32_t pair, Planes planes, Limits& limits);
    void gather_limits(Parallel& parallel);

    PairIncidence incidence_;  // of pairs that can fail
    std::span<const Vec4> positions_, motions_;
    ScratchArray<float> kept_;  // by pair, see kept_gap()
    ScratchArray<Limits> limits_;
    ScratchArray<std::uint8_t> kinds_, can_fail_, failed_;  // by pair
    ScratchArray<std::uint8_t> was_cut_;                    // by particle, in the last sweep
    ScratchArray<float> fractions_;
    ScratchArray<std::uint32_t> block_counts_;
    std::uint32_t sweeps_ = 0;
    bool incomplete_ = false;
};

}  // namespace weft
