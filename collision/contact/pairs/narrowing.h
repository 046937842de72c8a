#pragma once
// A second look at a list of near pairs: what is left of it for other motions and a shorter reach. It spares
// the search where that search would find nothing new.

#include <cstdint>
#include <span>

#include "collision/contact/pairs/pairs.h"
#include "engine/memory/scratch.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

class PairNarrowing {
  public:
    void lay_out(Scratch& scratch, std::size_t pairs);

    /// Leaves in the list, in their order, the pairs that PairFinder::find would list with these motions and
    /// this reach for all bodies. No motion is longer than `longest` [m].
    ///
    /// Preconditions: the list is whole, and of the same positions. It was found with a reach R and motions
    /// m, and each of these motions ends within (R - reach) / 2 of the way from 0 to m: so the gap of a pair
    /// along its normal, and that of its boxes, is less for m than now by no more than R - reach, and a pair
    /// that comes within reach now came within R.
    void narrow(Parallel& parallel, std::span<const Vec4> positions, std::span<const Vec4> motions,
                float reach, float longest, PairList& list);

  private:
    ScratchArray<std::uint32_t> kept_;  // by block of pairs
};

}  // namespace weft
