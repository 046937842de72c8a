#pragma once
// A cloth's triangles: what its normals and the air's forces on it are computed by.

#include <span>

#include "cloth/mesh/cook.h"
#include "cloth/surface/grid_cells.h"
#include "cloth/surface/triangle_groups.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/settings.h"

namespace weft {

/// A grid's cells, or any mesh's triangles.
class Surface {
  public:
    explicit Surface(const ClothModel& model);
    /// With groups that were read. Of use to be copied alone: what changes has no memory.
    Surface(const ClothModel& model, TriangleGroups&& saved);
    /// None of a grid.
    [[nodiscard]] const TriangleGroups& groups() const noexcept { return groups_; }
    /// Whether groups that were read name only what there is.
    [[nodiscard]] bool is_sound(std::uint32_t particles) const {
        return !cells_.empty() || groups_.is_sound(particles);
    }

    /// Of particles: means of the triangles' normals, weighted by area; +Y where they cancel out.
    void compute_normals(Parallel& parallel, std::span<const Vec4> positions, std::span<Vec4> normals);

    /// Particles have moved, and their normals with them, but by no call of this.
    void forget() noexcept { is_behind_ = true; }

    /// What the air does to a moving cloth.
    struct InAir {
        const Wind& wind;
        std::span<const Vec4> positions, velocities;
        /// Of the air at each particle [m/s]; empty where the mean wind blows everywhere.
        std::span<const Vec4> air_velocities;
        /// Since normals were last computed.
        bool has_moved = true;
    };
    /// The air's force on each particle [N], and in w its slope [N s/m]: a third of that on each of its
    /// triangles. The slope is at least the force's largest rate of change with the triangle's velocity.
    void compute_air_forces(Parallel& parallel, const InAir& cloth, std::span<Vec4> forces);

    [[nodiscard]] std::size_t bytes() const noexcept {
        return cells_.bytes() + groups_.bytes() + rows_.bytes();
    }

  private:
    GridCells cells_;        // empty for what is no grid,
    TriangleGroups groups_;  // which has these
    /// Of triangles: their area normals, since normals were computed until air forces are.
    AlignedBuffer<Vec4> rows_;
    bool is_behind_ = false;  // those are not of the particles' places
};

}  // namespace weft
