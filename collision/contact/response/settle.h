#pragma once
// Settling: turns the motion that a solver wants for a group into one that crosses nothing.

#include <cstdint>
#include <span>

#include "collision/contact/pairs/pairs.h"
#include "collision/contact/pairs/particle_ranges.h"
#include "collision/contact/response/common_motion.h"
#include "collision/contact/response/projection.h"
#include "collision/contact/response/truncation.h"
#include "engine/memory/scratch.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

/// Bodies that touch one another, directly or through others. Spans and numbers are of all bodies' particles.
struct BodyGroup {
    std::span<const ParticleRange> particles;
    std::span<const Vec4> positions;  ///< at the start, free of crossings [m]; w = inverse mass
    /// Whether nothing else holds any of its particles. All of them then get back the momentum that settling
    /// takes, by one displacement, which brings nothing nearer.
    bool is_free = false;
    /// Whether some particles are pinned to given places, off which a common motion may draw them. If the
    /// list is incomplete, none of the group then moves.
    bool is_pinned = false;
};

struct SettleResult {
    CommonMotionKind common = CommonMotionKind::none;
    bool list_was_incomplete = false;  ///< all particles got the common motion, or none moved
    /// Whether the common motion would leave a pinned particle farther from its place than standing still.
    /// Displacements are then unchanged: split and settle again without a common motion.
    bool draws_pins = false;
    std::uint32_t truncated = 0;        ///< particles with tau < 1
    std::uint32_t standing_planes = 0;  ///< pairs whose plane had to stand still
    std::uint32_t sweeps = 0;
    std::uint32_t uncertain = 0;  ///< pairs with no more gap than rounding, which may have crossed by it
    /// Fraction of all particles' motion that was cut: the sum of |wanted - had| over that of |wanted|.
    float motion_lost = 0;
};

/// Settles one group after another, each in four steps:
///   1. project: separates pairs found at x, within the displacements wanted.
///   2. split: takes out the common motion; relative() has the motions for the next detection.
///   3. The caller finds pairs, again at x, with motions = relative(), of the group's bodies.
///   4. settle: cuts displacements, with that list.
/// The state x + displacement, rounded to float, then has no crossing if x has none, except in pairs that are
/// exempt.
class Settler {
  public:
    /// Reserves memory for groups of that many particles, bodies and pairs in all.
    void lay_out(Scratch& scratch, std::size_t particles, std::size_t bodies, std::size_t pairs);
    /// lay_out() in two parts: memory for split(), and memory for project() and settle() only.
    void lay_out_split(Scratch& scratch, std::size_t particles, std::size_t bodies);
    void lay_out_cut(Scratch& scratch, std::size_t particles, std::size_t bodies, std::size_t pairs);

    /// See PairProjection::project.
    std::uint32_t project(Parallel& parallel, const BodyGroup& group, const PairList& pairs,
                          std::span<const std::uint8_t> exempt, PairLengths wanted, std::uint32_t iterations,
                          std::span<Vec4> displacements) {
        return projection_.project(parallel, group.positions, pairs, exempt, wanted, iterations,
                                   displacements);
    }

    /// Takes out the common motion. `most`: its most general kind; none: there is no common motion.
    void split(Parallel& parallel, const BodyGroup& group, std::span<const Vec4> displacements,
               CommonMotionKind most = CommonMotionKind::affine);
    /// Displacements without the common motion, in its frame [m], of all bodies' particles.
    [[nodiscard]] std::span<const Vec4> relative() const noexcept { return relative_.span(); }
    [[nodiscard]] const CommonMotion& common() const noexcept { return common_; }

    /// Preconditions: after split() of the same group and displacements; every corner of a pair is in the
    /// group; the list is what PairFinder lists with a reach of at least settings.floor.
    SettleResult settle(Parallel& parallel, const BodyGroup& group, const PairList& pairs,
                        std::span<const std::uint8_t> exempt, const TruncationSettings& settings,
                        std::span<Vec4> displacements);
    /// tau of every particle, as last settled.
    [[nodiscard]] std::span<const float> fractions() const noexcept { return truncation_.fractions(); }

  private:
    struct Totals {
        double wanted = 0, lost = 0;
        std::uint32_t truncated = 0;
    };
    struct Momentum {
        double mass = 0;     // [kg]
        double way[3] = {};  // mass times displacement [kg m]
    };
    struct Failures {
        std::uint32_t to_hold = 0, uncertain = 0;
    };

    [[nodiscard]] Vector3 mean_loss(Parallel& parallel, const BodyGroup& group,
                                    std::span<const Vec4> displacements);
    [[nodiscard]] bool draws_pins(Parallel& parallel, const BodyGroup& group,
                                  std::span<const Vec4> displacements);
    void place_ends(Parallel& parallel, const BodyGroup& group, std::span<const Vec4> displacements);
    std::uint32_t find_rounded_away(Parallel& parallel, const PairList& pairs, std::uint32_t& uncertain);
    Totals apply(Parallel& parallel, const BodyGroup& group, std::span<Vec4> displacements);

    PairProjection projection_;
    CommonMotionFit fit_;
    Truncation truncation_;
    CommonMotion common_;
    Vector3 given_back_ = Vector3::Zero();  // displacement of every particle of a free group [m]
    ScratchArray<Vec4> relative_;
    ScratchArray<Vec4> ends_;          // rounded positions at the end of the step
    ScratchArray<std::uint8_t> held_;  // by pair: rounding took its gap
    ScratchArray<Totals> partials_;
    ScratchArray<Momentum> momenta_;
    ScratchArray<Failures> failures_;
};

}  // namespace weft
