#pragma once
// Air forces on triangles.

#include <span>

#include "cloth/triangle_groups.h"
#include "engine/parallel_blocks.h"
#include "weft/settings.h"

namespace weft {

/// The air's force on each particle [N], and in w its slope [N s/m]: a third of that on each of its
/// triangles. The slope is at least the force's largest rate of change with the triangle's velocity.
/// `air_velocities`: of the air at each particle [m/s], or empty where the mean wind blows everywhere.
/// `triangle_rows`: the area normals of the present positions, which are overwritten.
void compute_air_forces(Parallel& parallel, const TriangleGroups& groups, std::span<const Vec4> velocities,
                        const Wind& wind, std::span<const Vec4> air_velocities, std::span<Vec4> triangle_rows,
                        std::span<Vec4> particle_forces);

}  // namespace weft
