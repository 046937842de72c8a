#pragma once
// Sums over a cooked mesh.

#include <cstdint>
#include <numeric>

#include "cloth/mesh/cook.h"

namespace weft {

/// Rest area of all triangles [m^2].
[[nodiscard]] inline double rest_area(const ClothModel& model) {
    const auto areas = model.rest_area.span();
    return std::accumulate(areas.begin(), areas.end(), 0.0);
}

/// Number of edges that keep the mesh from being closed.
[[nodiscard]] inline std::uint32_t open_edges(const ClothInfo& mesh) {
    return mesh.border_edges + mesh.misoriented_edges;
}

}  // namespace weft
