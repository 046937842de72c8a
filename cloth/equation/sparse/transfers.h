#pragma once
// Restriction and prolongation between a level and the next coarser one.

#include <cstdint>
#include <span>

#include "cloth/equation/sparse/interpolation.h"
#include "cloth/equation/sparse/stencil.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

/// body(BlockRange) for blocks of 64 coarse nodes: they are few, and have many neighbours.
template <class Body>
void coarse_ranges(Parallel& parallel, std::uint32_t nodes, const Body& body) {
    constexpr std::uint32_t size = 64;
    static_assert(size % Stencil::lanes == 0, "a block is whole groups");
    parallel.ranges(nodes, body, size);
}

/// P e of a coarse vector e, but 0 at pinned nodes. A fine vector may begin at another row of P.
struct Correction {
    const Interpolation& p;
    std::span<const Vec4> coarse;
    const std::uint8_t* pinned = nullptr;  ///< by row of P: not 0 where pinned; null: none is
    std::uint32_t first = 0;               ///< the row of P of the fine vector's first node
};

/// coarse = P^T fine.
void restrict_to(Parallel& parallel, const Interpolation& p, std::span<const Vec4> fine,
                 std::span<Vec4> coarse);
/// fine += P e, at all nodes of `fine`.
void prolong_from(Parallel& parallel, const Correction& correction, std::span<Vec4> fine);

}  // namespace weft
