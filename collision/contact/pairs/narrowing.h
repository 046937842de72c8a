#pragma once
// Narrows a list of near pairs to other motions and a shorter reach. It replaces a search where that search
// would find nothing new.

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
    /// Preconditions: the list is complete, and of the same positions. It was found with a reach R and
    /// motions m, and each of these motions ends within (R - reach) / 2 of the way from 0 to m. The gap of a
    /// pair along its normal for m, and that of its boxes, then exceeds the gap now by at most R - reach: a
    /// pair that comes within reach now came within R.
    void narrow(Parallel& parallel, std::span<const Vec4> positions, std::span<const Vec4> motions,
                float reach, float longest, PairList& list);

  private:
    ScratchArray<std::uint32_t> kept_;  // by block of pairs: the number that remains
};

}  // namespace weft
