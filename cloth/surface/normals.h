#pragma once
// Normals of triangles, for air forces, and of particles, for renderers.

#include <span>

#include "cloth/surface/grid_cells.h"
#include "cloth/surface/triangle_groups.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

/// Computes each triangle's normal times twice its area [m^2], by its row; w 0.
void compute_area_normals(Parallel& parallel, const TriangleGroups& groups, std::span<const Vec4> positions,
                          std::span<Vec4> area_normals);

/// Computes the normals of particles; see Surface.
void compute_normals(Parallel& parallel, GridCells& cells, std::span<const Vec4> positions,
                     std::span<Vec4> normals);
void compute_normals(Parallel& parallel, const TriangleGroups& groups, std::span<const Vec4> area_normals,
                     std::span<Vec4> normals);

}  // namespace weft
