#pragma once
// Air forces on triangles.

#include <span>

#include "cloth/surface/grid_cells.h"
#include "cloth/surface/triangle_groups.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/settings.h"

namespace weft {

/// Computes air forces; see Surface. `triangle_rows` has the area normals of the present positions, and is
/// overwritten.
void compute_air_forces(Parallel& parallel, const TriangleGroups& groups, std::span<const Vec4> velocities,
                        const Wind& wind, std::span<const Vec4> air_velocities, std::span<Vec4> triangle_rows,
                        std::span<Vec4> particle_forces);
void compute_air_forces(Parallel& parallel, GridCells& cells, std::span<const Vec4> positions,
                        std::span<const Vec4> velocities, const Wind& wind,
                        std::span<const Vec4> air_velocities, std::span<Vec4> particle_forces);

}  // namespace weft
