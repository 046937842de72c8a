#pragma once
// Projection of the wanted motion: pairs come less near, and pass on momentum before their motion is cut.

#include <cstdint>
#include <span>

#include "collision/contact/pairs/incidence.h"
#include "collision/contact/pairs/pairs.h"
#include "engine/memory/scratch.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

/// A length for each pair [m], or one for all.
struct PairLengths {
    float all = 0;
    std::span<const float> each = {};  ///< by pair; empty: all have the same
    [[nodiscard]] float operator[](std::uint32_t pair) const noexcept {
        return each.empty() ? all : each[pair];
    }
};

/// Jacobi projections, weighted by mass (position based dynamics, Mueller et al. 2007, of all pairs at once).
class PairProjection {
  public:
    void lay_out(Scratch& scratch, std::size_t particles, std::size_t pairs);

    /// Projects up to `iterations` times. Each pair whose gap after the motion, along its normal at the
    /// start, is less than wanted computes the impulse that would open it to that. The pair applies 1 / n of
    /// it, with n such pairs at its busiest corner that can move. No particle moves farther than the mean of
    /// what its pairs ask for. Both sides have the same share, so linear momentum is kept to rounding.
    /// Particles of inverse mass 0 stay as they are. Pairs that are exempt (exempt[pair] != 0; may be empty),
    /// or whose normal.w is not positive, are left out.
    /// positions.w is the inverse mass. Displacements [m] are of the step, in and out; their w is kept.
    /// Returns the pairs that were too near in the first iteration. A list with more pairs than reserved for
    /// is left as it is. A list that overflowed is projected as far as it goes.
    std::uint32_t project(Parallel& parallel, std::span<const Vec4> positions, const PairList& pairs,
                          std::span<const std::uint8_t> exempt, PairLengths wanted, std::uint32_t iterations,
                          std::span<Vec4> displacements);

  private:
    std::uint32_t find_impulses(Parallel& parallel, std::span<const Vec4> positions, const PairList& pairs,
                                std::span<const std::uint8_t> exempt, PairLengths wanted,
                                std::span<const Vec4> displacements);
    void share_impulses(Parallel& parallel, std::span<const Vec4> positions, const PairList& pairs);
    void apply_impulses(Parallel& parallel, std::span<const Vec4> positions, const PairList& pairs,
                        std::span<Vec4> displacements);

    PairIncidence incidence_;                 // of pairs with an impulse
    ScratchArray<std::uint8_t> has_impulse_;  // by pair
    ScratchArray<float> impulses_;            // by pair: displacement over inverse mass [m kg]
    ScratchArray<std::uint32_t> sharers_;     // by particle: pairs with an impulse
    ScratchArray<std::uint32_t> block_counts_;
};

}  // namespace weft
