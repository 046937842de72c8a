#pragma once
// Surfaces that lie exactly on one another, as layers of a garment that was exported flat. No plane lies
// between them, so no motion of theirs can be certified to cross nothing.

#include <span>

#include "collision/contact/pairs/pair_finder.h"
#include "collision/contact/pairs/pairs.h"
#include "weft/types.h"

namespace weft {

/// Moves features that touch within rounding `distance` [m] apart: of each pair the one of the later body,
/// off the surface that it stands on or, where both lie along one surface, out on its front. Layers that face
/// opposite ways go both out on their fronts; layers of one body that face the same way stay. `ways` is
/// scratch. Both spans are of all bodies' particles.
/// Returns whether anything moved. Of n layers at one place, all are apart after n - 1 calls.
bool part_touching(std::span<const ContactBody> bodies, const PairList& pairs, float distance,
                   std::span<Vec4> positions, std::span<Vec4> ways);

}  // namespace weft
