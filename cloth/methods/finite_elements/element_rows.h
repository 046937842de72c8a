#pragma once
// The pairs of particles that share an element: the rows of the finite elements' matrix.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cloth/mesh/rest/rest_elements.h"

namespace weft {

/// The neighbours of each particle in compressed rows, ascending.
struct ElementRows {
    using Pair = std::array<std::uint32_t, 2>;
    /// Repeated pairs count once.
    ElementRows(std::uint32_t particles, std::vector<Pair> pairs);

    /// Pairs of the ends of edges and, for dihedral bending, of the apexes of hinges.
    [[nodiscard]] static ElementRows of_triangles(const ClothModel& model, std::span<const Hinge> hinges);
    /// All pairs that quadratic bending couples.
    [[nodiscard]] static ElementRows of_quadratic_bending(const ClothModel& model, const Bending& bending);

    /// The half-edge of `neighbour` in the row of `particle`. Precondition: the row has it.
    [[nodiscard]] std::size_t half_edge(std::uint32_t particle, std::uint32_t neighbour) const;

    std::vector<std::uint32_t> offsets, neighbours;
};

}  // namespace weft
