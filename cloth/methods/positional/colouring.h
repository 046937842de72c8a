#pragma once
// Springs in colours, for Gauss-Seidel in parallel.
//
// Invariant: no two springs of a colour share a particle. So the springs of a colour may be solved in any
// order, by any threads, and scatter to their particles: the bytes of the result are the same.

#include <cstdint>
#include <span>
#include <vector>

#include "cloth/mesh/cook.h"
#include "engine/memory/aligned_buffer.h"

namespace weft {

/// The springs of a cloth, each once, colour by colour, ascending by their lower particle. A colour begins at
/// a multiple of `lanes`. Places that are left in its last group join two stand-ins behind the last particle,
/// and must have no stiffness.
struct SpringColours {
    static constexpr std::uint32_t lanes = 16;
    static constexpr std::uint32_t stand_ins = 2;  ///< particles behind the last one
    static constexpr std::uint32_t no_half_edge = ~0u;

    std::vector<std::uint32_t> offsets;          ///< springs of colour c: [offsets[c], offsets[c + 1])
    AlignedBuffer<std::uint32_t> first, second;  ///< the springs' particles
    AlignedBuffer<std::uint32_t> half_edges;     ///< its half-edge in the model; no_half_edge: a stand-in

    [[nodiscard]] std::uint32_t colours() const noexcept {
        return static_cast<std::uint32_t>(offsets.size()) - 1;
    }
    [[nodiscard]] std::uint32_t springs() const noexcept { return offsets.back(); }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return offsets.size() * sizeof(std::uint32_t) + first.bytes() + second.bytes() + half_edges.bytes();
    }
};

/// A grid has 8 colours; a general mesh as many as its best-connected particle has springs, or a few more,
/// each of about as many springs.
[[nodiscard]] SpringColours colour_springs(const ClothModel& model);

}  // namespace weft
