#pragma once
// Triangles and their corners, laid out for vectors of any width. Kernels for normals and air forces of
// general meshes read them.
//
// A row holds one triangle's value of a quantity, and rows are computed in groups of 16 lanes. Each triangle
// is owned by one of its corners, and a particle owns at most two: so the triangles of 16 particles in a row
// are two groups of rows. That saves gathers on any mesh: the owner is one corner in three, and its own two
// are among the six or so triangles that a particle sums. Triangles that find no owner, which are few, follow
// in groups of their own.
//
// A lane without a triangle names the same corner three times, so that it has no area and its row is zero.
// The last row is always such a row: a particle with fewer triangles than others of its group sums it
// instead.
//
// Where the corners, or the rows to sum, of 16 lanes have consecutive numbers, one load replaces the gather.
// In grids that holds for a second corner and two more triangles, since owners are chosen alike everywhere.

#include <cstdint>
#include <vector>

#include "cloth/mesh/cook.h"
#include "engine/memory/shared_buffer.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

struct TriangleGroups {
    static constexpr std::uint32_t lanes = 16;
    static_assert(block_size % lanes == 0, "a block is whole groups");
    static constexpr std::uint32_t most_owned = 2;
    /// The number of rows owned by the particles before the i-th. Precondition: i is a multiple of 16.
    static constexpr std::uint32_t own_rows(std::uint32_t i) { return most_owned * i; }

    TriangleGroups() = default;
    explicit TriangleGroups(const ClothModel& model);

    std::uint32_t particles = 0;
    std::uint32_t rows = 0;  ///< whole groups

    /// [group * 3 + corner]: the first of a run of 16 particles; or `listed` plus the index in `corner_lists`
    /// at which the 16 begin. Lists hold offsets of rows [bytes].
    static constexpr std::uint32_t listed = 1u << 31;
    SharedBuffer<std::uint32_t> corner_sources, corner_lists;

    /// Rows that the particles of group g sum besides their own: first the runs that begin at sum_runs[k],
    /// k in [first_runs[g], first_runs[g + 1]), then those of the lists [first_lists[g], first_lists[g + 1]).
    SharedBuffer<std::uint32_t> first_runs, sum_runs, first_lists, sum_lists;

    /// Calls visit(list) and visit.value(number) for all of these.
    template <class Self, class Visit>
    static void for_each_list(Self& self, Visit& visit) {
        visit.value(self.particles);
        visit.value(self.rows);
        visit(self.corner_sources);
        visit(self.corner_lists);
        visit(self.first_runs);
        visit(self.sum_runs);
        visit(self.first_lists);
        visit(self.sum_lists);
    }
    /// Whether lists that were read have valid sizes and indices, for so many particles.
    [[nodiscard]] bool is_sound(std::uint32_t particle_count) const;
    [[nodiscard]] std::size_t bytes() const noexcept {
        return corner_sources.bytes() + corner_lists.bytes() + first_runs.bytes() + sum_runs.bytes() +
               first_lists.bytes() + sum_lists.bytes();
    }

  private:
    void list_corners(const std::vector<Triangle>& triangles);
    void list_sums(std::vector<std::vector<std::uint32_t>> rows_of_particles);
};

}  // namespace weft
