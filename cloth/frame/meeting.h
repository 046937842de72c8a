#pragma once
// How cloths of a World meet one another.

#include <span>

#include "engine/parallel_blocks.h"

namespace weft {

struct Cloth;

/// What a World asks of contact between cloths. A World without one looks for nothing: each of its cloths is
/// an island of its own. Islands may be taken side by side, so what is kept between the calls is kept by
/// cloth; an island's cloths are always in the same order, that of their ids.
class Meeting {
  public:
    virtual ~Meeting() = default;

    /// Whether the two may touch at all.
    [[nodiscard]] virtual bool may_touch(const Cloth& a, const Cloth& b) const = 0;
    /// From how far off a cloth is felt [m].
    [[nodiscard]] virtual float reach(const Cloth& cloth) const = 0;
    /// A substep of an island of two cloths or more begins: finds what is near what. h: its length [s].
    virtual void meet(Parallel& parallel, std::span<Cloth* const> island, float h) = 0;
    /// Each cloth has been solved: sees to it that what must hold between them does.
    virtual void settle(Parallel& parallel, std::span<Cloth* const> island, float h) = 0;
};

}  // namespace weft
