#pragma once
// Which particles share an element, for the rows of the matrix of elements.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cloth/mesh/rest/rest_elements.h"

namespace weft {

/// In compressed rows, ascending.
struct ElementRows {
    using Pair = std::array<std::uint32_t, 2>;
    /// Repeated pairs count once.
    ElementRows(std::uint32_t particles, std::vector<Pair> pairs);

    /// The ends of edges and, for dihedral bending, the apexes of hinges.
    [[nodiscard]] static ElementRows of_triangles(const ClothModel& model, std::span<const Hinge> hinges);
    /// All that quadratic bending couples.
    [[nodiscard]] static ElementRows of_quadratic_bending(const ClothModel& model, const Bending& bending);

    /// Where `neighbour` is in the row of `particle`. Precondition: it is.
    [[nodiscard]] std::size_t half_edge(std::uint32_t particle, std::uint32_t neighbour) const;

    std::vector<std::uint32_t> offsets, neighbours;
};

}  // namespace weft
