#pragma once
// The search for contacts in a block of slots, many candidates at a time; compiled once for each kind of
// machine.

#include <array>
#include <cstdint>

#include "collision/search/grid_kernels.h"
#include "collision/search/hash_grid.h"
#include "collision/search/rest_filter.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

/// The pairs of a block that are closer than the distance, in the order of their first particles' slots.
struct BlockHits {
    /// A slot is left over, for a scalar search, if it has more than per_slot hits or has to look through
    /// a range of more than longest_range slots.
    static constexpr std::uint32_t per_slot = 16, longest_range = 64;
    static_assert(longest_range <= HashGrid::padding, "all ranges of a slot are read as far as its longest");
    static constexpr std::uint32_t capacity = block_size * per_slot + 4 * longest_range;

    std::uint32_t count = 0;
    std::array<std::uint32_t, capacity + 16> particles, others;
    std::uint32_t left_over_count = 0;
    BlockOfIndices left_over;  // slots whose hits are not here
};

using SlotFlags = std::array<bool, block_size>;

/// Finds the hits of the wanted particles of a block of slots. A slot's ranges may overlap: a pair in the
/// overlap is found twice. `shape`: that with which the grid was built.
void find_hits(const HashGrid& grid, CellShape shape, float distance_squared, const BlockRange& slots,
               const SlotFlags& wanted, BlockHits& hits);

/// Ranges of candidates for each slot of a block. A slot's ranges do not overlap.
struct SlotRanges {
    static constexpr std::uint32_t per_slot = 9;
    std::array<std::array<SlotRange, per_slot>, block_size> of;
};

/// Finds the hits of a block of slots in their ranges. Slots with more than BlockHits::per_slot hits are left
/// over.
void find_hits_in_ranges(const SortedParticles& sorted, float distance_squared, const BlockRange& slots,
                         const SlotRanges& ranges, BlockHits& hits);

/// Removes the pairs for which the filter has leaves_alone().
void drop_rest_pairs(const RestFilter& filter, BlockHits& hits);

}  // namespace weft
