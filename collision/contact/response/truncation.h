#pragma once
// How far each particle may go of its motion, so that no pair of features meets: divide and truncate (planes
// between the sides of pairs, arXiv 2604.15513, 2026), with planes that move along where they can (ours).
//
// The certificate. Of a pair with unit normal n at x, and motions E of which particle i goes the part tau_i:
//     a(s) = min over A of n . (x_i + s tau_i E_i),    b(s) = max over B of n . (x_j + s tau_j E_j),
// for s from 0, the start, to 1, the end. Where a > b, a plane across n is between the sides, and they do not
// meet. Each n . x_i(s) is linear in s; the least of linear functions is concave, and so is minus the
// greatest; so the gap a - b is concave, and nowhere less than the smaller of its two ends. So a gap of at
// least eps at both ends is one all the way, and only the end need be looked at. No other time, no other
// direction, no root of a cubic.
//
// Where the end fails, vertices that close the gap are cut, and no others: what is left of the gap is shared
// in the ratio in which the sides close it. A cut vertex may bring another pair to fail, hence sweeps. A pair
// that keeps failing gets a plane that stands still in the middle of its gap, with A on one side and B on the
// other: cutting any vertex further leaves that true. So after a bounded number of rounds no pair fails.

#include <cstdint>
#include <span>

#include "collision/contact/pairs/incidence.h"
#include "collision/contact/pairs/pairs.h"
#include "engine/memory/scratch.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

struct TruncationSettings {
    /// A gap is never cut below this [m], unless it was at the start; then it may not become less. Rounding
    /// at the end of the step must not cross it: where coordinates are so large that it could, more is kept.
    float floor = 1e-5f;
    std::uint32_t sweeps = 30;  ///< before planes stand still
};

class Truncation {
  public:
    void lay_out(Scratch& scratch, std::size_t particles, std::size_t pairs);

    /// Finds tau. Each pair keeps a gap of min(floor, gap at the start), save those that are exempt
    /// (exempt[pair] != 0; may be empty). Corners of other pairs without a positive gap do not move, nor do
    /// those of a pair with a value that is not finite. Pinned particles are cut as all others.
    /// Preconditions: the list holds all pairs that these motions bring nearer than the floor (E, without
    /// common motion: PairFinder::find with motions = E). Where it is incomplete (overflowed, or more pairs
    /// than reserved for), tau is 0 for all. Spans are of all bodies' particles.
    void cut(Parallel& parallel, std::span<const Vec4> positions, std::span<const Vec4> motions,
             const PairList& pairs, std::span<const std::uint8_t> exempt, const TruncationSettings& settings);

    /// Holds the corners of pairs that the caller found to fail by rounding: cut() again, with tau = 0 there.
    /// held_pairs[pair] != 0 says which. Precondition: after cut(), with the same arguments.
    void cut_again(Parallel& parallel, const PairList& pairs, std::span<const std::uint8_t> held_pairs,
                   const TruncationSettings& settings);

    /// tau of every particle, 0 to 1.
    [[nodiscard]] std::span<const float> fractions() const noexcept { return fractions_.span(); }
    /// The gap that the pair keeps [m]; 0 for those that were left out or do not move.
    [[nodiscard]] float kept_gap(std::uint32_t pair) const noexcept { return lanes_[pair].kept; }
    /// Whether a pair was left out.
    [[nodiscard]] bool is_left_out(std::uint32_t pair) const noexcept { return kinds_[pair] == left_out; }

    [[nodiscard]] bool list_was_incomplete() const noexcept { return incomplete_; }
    [[nodiscard]] std::uint32_t sweeps() const noexcept { return sweeps_; }
    [[nodiscard]] std::uint32_t standing_planes(Parallel& parallel, const PairList& pairs);

  private:
    /// What a pair's sides do along its normal, from its first corner.
    struct Lane {
        float start[4], motion[4];  // n . x and n . E of its corners [m]
        float kept;                 // the gap that must be kept [m]
    };
    struct Limits {
        float of[4];  // what tau of each corner may be
    };
    enum Kind : std::uint8_t {
        at_ease,   // keeps its gap whatever tau is
        left_out,  // exempt
        moving,    // its plane may move
        standing,  // its plane stands still
        held,      // its corners do not move
    };
    struct Sides;

    void prepare(Parallel& parallel, std::span<const Vec4> positions, std::span<const Vec4> motions,
                 const PairList& pairs, std::span<const std::uint8_t> exempt, float floor);
    static Kind prepare_pair(const FeaturePair& pair, const PairShape& shape, std::uint32_t corners_of_a,
                             std::span<const Vec4> positions, std::span<const Vec4> motions, float floor,
                             Lane& lane);
    void cut_until_none_fails(Parallel& parallel, const PairList& pairs, std::uint32_t most_sweeps);
    enum class Planes : std::uint8_t { move, stand_where_failing, stand };
    std::uint32_t sweep(Parallel& parallel, const PairList& pairs, Planes planes, bool first);
    bool limit_pair(const PairList& pairs, std::uint32_t pair, Planes planes, Limits& limits);
    void gather_limits(Parallel& parallel);

    PairIncidence incidence_;  // of pairs that can fail
    ScratchArray<Lane> lanes_;
    ScratchArray<Limits> limits_;
    ScratchArray<std::uint8_t> kinds_, can_fail_, failed_;  // by pair
    ScratchArray<std::uint8_t> was_cut_;                    // by particle, in the last sweep
    ScratchArray<float> fractions_;
    ScratchArray<std::uint32_t> block_counts_;
    std::uint32_t sweeps_ = 0;
    bool incomplete_ = false;
};

}  // namespace weft
