#pragma once
// Triangles and their corners, laid out for vectors of any width: what normals and air forces are computed
// by.
//
// A quantity of each triangle is a row, and rows are worked on in groups of 16 lanes. A triangle belongs to
// one of its corners, and a particle has two triangles at most: those of a group of 16 particles are two
// groups of rows, so that one corner in three, and two of the some six triangles that a particle sums, are
// loaded as they lie, on any mesh. The few triangles that no corner has room for, if any, are groups of their
// own at the end. Lanes without a triangle have three times the same corner: they have no area and come to
// zero rows, and it is the last row, always one of these, that particles sum where others of their group have
// more triangles.
//
// Whatever else is named by 16 lanes in a row, one by one upwards, is loaded as it lies, too: in grids that
// is another corner and two more triangles, since the triangles are shared out alike from particle to
// particle.

#include <cstdint>
#include <vector>

#include "cloth/mesh/cook.h"
#include "engine/aligned_buffer.h"
#include "engine/parallel_blocks.h"

namespace weft {

struct TriangleGroups {
    static constexpr std::uint32_t lanes = 16;
    static_assert(block_size % lanes == 0, "a block is whole groups");
    static constexpr std::uint32_t most_owned = 2;
    /// The rows of what the particles before the i-th own. Precondition: i is a multiple of 16.
    static constexpr std::uint32_t own_rows(std::uint32_t i) { return most_owned * i; }

    TriangleGroups() = default;
    explicit TriangleGroups(const CookedCloth& model);

    std::uint32_t particles = 0;
    std::uint32_t rows = 0;  ///< whole groups

    /// Of [group * 3 + corner]: the first of a run of particles, or where in `corner_lists` the sixteen are,
    /// plus `listed`. Lists hold offsets of rows [bytes].
    static constexpr std::uint32_t listed = 1u << 31;
    AlignedBuffer<std::uint32_t> corner_sources, corner_lists;

    /// What the particles of group g sum besides their own: first the runs of rows that begin at sum_runs[k],
    /// k in [first_runs[g], first_runs[g + 1]), then those of the lists [first_lists[g], first_lists[g + 1]).
    AlignedBuffer<std::uint32_t> first_runs, sum_runs, first_lists, sum_lists;

    [[nodiscard]] std::size_t bytes() const noexcept {
        return corner_sources.bytes() + corner_lists.bytes() + first_runs.bytes() + sum_runs.bytes() +
               first_lists.bytes() + sum_lists.bytes();
    }

  private:
    void list_corners(const std::vector<Triangle>& triangles);
    void list_sums(std::vector<std::vector<std::uint32_t>> rows_of_particles);
};

}  // namespace weft
