#pragma once
// Surfaces that lie exactly on one another, as layers of a garment that was exported flat. No plane lies
// between them, so no motion of theirs can be certified to cross nothing.

#include <span>

#include "collision/contact/pairs/pair_finder.h"
#include "collision/contact/pairs/pairs.h"
#include "weft/types.h"

namespace weft {

/// Returns true if any pair touches within rounding.
[[nodiscard]] bool any_touch(std::span<const ContactBody> bodies, const PairList& pairs,
                             std::span<const Vec4> positions);

/// Moves features that touch within rounding `distance` [m] apart. Of each pair, the feature of the later
/// body moves off the surface on which it stands or, where both lie along one surface, out of its front.
/// Layers that face opposite ways both move out of their fronts. Within one body, borders that lie side by
/// side both move into their surfaces, and layers that face the same way stay. `ways` is scratch. Both spans
/// are of all bodies' particles. Returns whether anything moved. n layers at one place are apart after n - 1
/// calls.
bool part_touching(std::span<const ContactBody> bodies, const PairList& pairs, float distance,
                   std::span<Vec4> positions, std::span<Vec4> ways);

}  // namespace weft
