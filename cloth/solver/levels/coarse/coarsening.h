#pragma once
// Coarsening of one level to the next: which nodes stay, and how the others interpolate from them. It works
// on any graph, and runs once, when a cloth gets its multilevel solver.

#include <cstdint>
#include <span>
#include <vector>

#include "cloth/equation/sparse/interpolation.h"

namespace weft {

/// Nodes joined by springs, in compressed rows; each spring at both its ends.
struct SpringGraph {
    std::vector<std::uint32_t> offsets, neighbours;
    std::vector<float> stiffness;  ///< >= 0
    std::vector<float> lengths;    ///< >= 0; infinite: no path follows the spring

    [[nodiscard]] std::uint32_t nodes() const noexcept {
        return static_cast<std::uint32_t>(offsets.size()) - 1;
    }
    [[nodiscard]] std::uint32_t degree(std::uint32_t node) const noexcept {
        return offsets[node + 1] - offsets[node];
    }
};

/// Nodes that springs join, directly or by way of others. Components are numbered by their first nodes.
struct Components {
    std::vector<std::uint32_t> of_node;
    std::vector<std::uint32_t> offsets, nodes;  ///< of component c, ascending: [offsets[c], offsets[c + 1])

    [[nodiscard]] std::uint32_t count() const noexcept {
        return static_cast<std::uint32_t>(offsets.size()) - 1;
    }
    [[nodiscard]] std::uint32_t size(std::uint32_t component) const noexcept {
        return offsets[component + 1] - offsets[component];
    }
};
[[nodiscard]] Components components_of(const SpringGraph& graph);

/// Makes P^T by rows from the rows of P.
void store_transpose(Interpolation& p);

/// The coarse nodes, from which the next level is made.
struct Coarsening {
    Interpolation interpolation;
    std::vector<std::uint32_t> owner;  ///< the coarse node nearest to each fine one, along the springs
    std::vector<float> distance;       ///< from each fine node to its owner
};

/// Keeps about nodes / ratio nodes of each component, at least one, whatever other components there are.
/// Components of at most `most_direct` nodes are solved directly, and nodes without springs need no
/// correction: they keep no node, and their rows of P are 0.
[[nodiscard]] Coarsening coarsen(const SpringGraph& graph, const Components& components, float ratio,
                                 std::uint32_t most_direct);

}  // namespace weft
