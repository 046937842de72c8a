#pragma once
// Particles that lie in one place at rest, as along a cut.

#include <optional>
#include <vector>

#include "cloth/mesh/cook.h"
#include "collision/particles/rest_neighbours.h"

namespace weft {

/// Which particles springs join, and what parted as well: else avoidance would drive a cut's lips apart.
struct JoinsWithCopies {
    std::vector<std::uint32_t> offsets, neighbours;
    std::vector<float> lengths;  ///< 0 between what parted [m]

    [[nodiscard]] RestGraph graph() const noexcept { return {offsets, neighbours, lengths}; }
};

/// None: no two particles lie in one place.
[[nodiscard]] std::optional<JoinsWithCopies> joins_with_copies(const ClothModel& model);

}  // namespace weft
