#pragma once
// From one level of a hierarchy to the next coarser one: which nodes stay, and how the others interpolate
// from them. Works on any graph; done once, when a cloth gets its multilevel solver.

#include <cstdint>
#include <span>
#include <vector>

#include "cloth/system/sparse/interpolation.h"

namespace weft {

/// Nodes joined by springs, in compressed rows; each spring at both its ends.
struct SpringGraph {
    std::vector<std::uint32_t> offsets, neighbours;
    std::vector<float> stiffness;  ///< >= 0
    std::vector<float> lengths;    ///< >= 0; infinite where a spring is no way to go

    [[nodiscard]] std::uint32_t nodes() const noexcept {
        return static_cast<std::uint32_t>(offsets.size()) - 1;
    }
    [[nodiscard]] std::uint32_t degree(std::uint32_t node) const noexcept {
        return offsets[node + 1] - offsets[node];
    }
};

/// What the next level is made from.
struct Coarsening {
    Interpolation interpolation;
    std::vector<std::uint32_t> owner;  ///< the coarse node nearest to each fine one, along the springs
    std::vector<float> distance;       ///< to its owner
};

/// Keeps about nodes / ratio nodes, at least one a component.
[[nodiscard]] Coarsening coarsen(const SpringGraph& graph, float ratio);

}  // namespace weft
