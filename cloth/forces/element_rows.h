#pragma once
// Which particles share an element, for the rows of the matrix of elements.

#include <cstdint>
#include <span>
#include <vector>

#include "cloth/forces/rest_elements.h"

namespace weft {

/// In compressed rows, ascending: the edges' ends, and the apexes of each hinge.
struct ElementRows {
    ElementRows(const CookedCloth& model, std::span<const Hinge> hinges);

    /// Where `neighbour` is in the row of `particle`. Precondition: it is.
    [[nodiscard]] std::size_t half_edge(std::uint32_t particle, std::uint32_t neighbour) const;

    std::vector<std::uint32_t> offsets, neighbours;
};

}  // namespace weft
