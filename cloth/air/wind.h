#pragma once
// Air forces on triangles.

#include <span>

#include "cloth/surface/grid_cells.h"
#include "cloth/surface/triangle_groups.h"
#include "engine/threads/parallel_blocks.h"
#include "engine/vector.h"
#include "weft/settings.h"

namespace weft {

/// A cloth in moving air. Spans have an element for each particle.
struct ClothInAir {
    const Wind* wind = nullptr;
    float wind_scale = 1;                   ///< of the mean wind's velocity; `air_velocities` have it already
    float drag_scale = 1, lift_scale = 1;   ///< of the wind's coefficients
    std::span<const Vec4> air_velocities;   ///< [m/s]; empty: the mean wind blows everywhere
    std::span<const Vec4> positions;        ///< [m]
    std::span<const Vec4> velocities;       ///< at which the air acts [m/s]
    std::span<const Vec4> from_velocities;  ///< at which forces are stored, along their slopes [m/s]

    [[nodiscard]] Vector3 mean_wind() const { return wind_scale * to_vector(wind->velocity); }
};

/// Computes air forces; see Surface. `triangle_rows` has the area normals of the positions, and is
/// overwritten.
void compute_air_forces(Parallel& parallel, const TriangleGroups& groups, const ClothInAir& cloth,
                        std::span<Vec4> triangle_rows, std::span<Vec4> particle_forces);
void compute_air_forces(Parallel& parallel, GridCells& cells, const ClothInAir& cloth,
                        std::span<Vec4> particle_forces);

}  // namespace weft
