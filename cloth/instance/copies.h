#pragma once
// Particles that coincide at rest, as along a cut.

#include <optional>
#include <vector>

#include "cloth/mesh/cook.h"
#include "collision/particles/rest_neighbours.h"

namespace weft {

/// Graph of the springs, with an edge between each two coincident particles: without these, avoidance would
/// drive the lips of a cut apart.
struct JoinsWithCopies {
    std::vector<std::uint32_t> offsets, neighbours;
    std::vector<float> lengths;  ///< 0 between coincident particles [m]

    [[nodiscard]] RestGraph graph() const noexcept { return {offsets, neighbours, lengths}; }
};

/// None: no two particles coincide.
[[nodiscard]] std::optional<JoinsWithCopies> joins_with_copies(const ClothModel& model);

}  // namespace weft
