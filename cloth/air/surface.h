#pragma once
// A cloth's triangles, laid out for computing its normals and the air's forces on it.

#include <span>

#include "cloth/air/wind.h"
#include "cloth/mesh/cook.h"
#include "cloth/surface/grid_cells.h"
#include "cloth/surface/triangle_groups.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/settings.h"

namespace weft {

/// The surface of a cloth: a grid's cells, or any mesh's triangles.
class Surface {
  public:
    explicit Surface(const ClothModel& model);
    /// Makes a surface of groups that were read, to be copied only: buffers that change have no memory.
    Surface(const ClothModel& model, TriangleGroups&& saved);
    /// The triangles' groups; empty for a grid.
    [[nodiscard]] const TriangleGroups& groups() const noexcept { return groups_; }
    /// Whether groups that were read have valid sizes and indices.
    [[nodiscard]] bool is_sound(std::uint32_t particles) const {
        return !cells_.empty() || groups_.is_sound(particles);
    }

    /// Computes particles' normals: means of triangles' normals, weighted by area; +Y where they cancel out.
    void compute_normals(Parallel& parallel, std::span<const Vec4> positions, std::span<Vec4> normals);

    /// Call this when particles and their normals have changed otherwise than through this object.
    void forget() noexcept { is_behind_ = true; }

    /// Computes the air's force on each particle [N], and in w its slope [N s/m]: a third of that on each of
    /// its triangles. The slope is at least the force's largest rate of change with the triangle's velocity.
    /// `keeps_normals`: these positions' normals were computed last, and no forces since.
    void compute_air_forces(Parallel& parallel, const ClothInAir& cloth, bool keeps_normals,
                            std::span<Vec4> forces);

    [[nodiscard]] std::size_t bytes() const noexcept {
        return cells_.bytes() + groups_.bytes() + rows_.bytes();
    }

  private:
    GridCells cells_;        // empty for a general mesh
    TriangleGroups groups_;  // empty for a grid
    /// A row for each triangle: its area normal, until air forces overwrite it.
    AlignedBuffer<Vec4> rows_;
    bool is_behind_ = false;  // rows_ are not of the present positions
};

/// The air's force in the equation of one cloth.
struct AirForce {
    Surface* surface = nullptr;  ///< null: there is no air
    ClothInAir cloth;            ///< but for its velocities
    std::span<Vec4> forces;      ///< see ExternalForces

    /// Computes the forces from the air's force at these velocities. `keeps_normals`: see Surface.
    void linearise(Parallel& parallel, std::span<const Vec4> velocities, bool keeps_normals = false) const;
};

}  // namespace weft
