#pragma once
// The parts of the grid's sort that are done many particles at a time, compiled once for each kind of
// machine.

#include <array>
#include <cstdint>
#include <span>

#include "collision/search/cells.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

enum class CellShape : std::uint8_t { row, cube };

using BlockOfIndices = std::array<std::uint32_t, block_size>;

/// The buckets of a block's particles, the first of which is `first`. Those that are not finite are spread
/// over all buckets.
void find_buckets(const Cells& cells, CellShape shape, std::span<const Vec4> block, std::uint32_t first,
                  BlockOfIndices& buckets);

/// Entries of the sort: particles and their buckets, before they have slots.
struct GridEntries {
    std::uint32_t* buckets;
    std::uint32_t* particles;
};
/// Puts a block's particles in order of part = bucket >> shift, keeping their order inside each.
/// part_starts[p]: where part p starts in the block, for p up to and with the number of parts.
void partition_block(const BlockOfIndices& buckets, const BlockRange& range, std::uint32_t shift,
                     std::uint32_t parts, const GridEntries& entries, std::uint16_t* part_starts);

/// Turns counts into starts: values[k] = first + the sum of the counts before it.
void running_sum(std::span<std::uint32_t> values, std::uint32_t first);

/// Sets x[s], y[s], z[s] to the position of particles[s], for s from begin to end.
void copy_sorted(std::span<const Vec4> positions, const std::uint32_t* particles, std::uint32_t begin,
                 std::uint32_t end, float* x, float* y, float* z);

}  // namespace weft
