#pragma once
// A surface cut into cells of equal size, and the triangles between their centres.

#include <cstdint>
#include <vector>

#include "cloth/proxy/plain_surface.h"

namespace weft {

struct SurfaceCells {
    std::vector<std::uint32_t> centres;   ///< points
    std::vector<std::uint32_t> of_point;  ///< each point's cell
};

/// Centres on borders lie an edge apart and at corners, the others are spread evenly over the surface, so
/// many as are missing to `wanted`. A point belongs to the cell of the nearest centre that it is connected
/// with.
[[nodiscard]] SurfaceCells cut_into_cells(const PlainSurface& surface, float edge, std::uint32_t wanted);

/// The centres, and a triangle where three cells meet. An edge has at most two, wound alike.
[[nodiscard]] PlainSurface triangles_between(const PlainSurface& surface, const SurfaceCells& cells);

/// Adds centres on the borders, and their cells' points there.
void add_borders(const PlainSurface& surface, float edge, SurfaceCells& cells);

constexpr std::uint32_t no_cell = ~0u;

}  // namespace weft
