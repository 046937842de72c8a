#pragma once
// Loops over the particles of a group of bodies, as ranges of all bodies' particles.

#include <algorithm>
#include <cstdint>
#include <span>

#include "engine/threads/parallel_blocks.h"

namespace weft {

/// [first, first + count) of all bodies' particles.
struct ParticleRange {
    std::uint32_t first, count;
};

/// Number of blocks of the loops below: at most the particles' block_count and one for each range.
inline std::uint32_t block_count(std::span<const ParticleRange> ranges) {
    std::uint32_t blocks = 0;
    for (const ParticleRange& range : ranges) blocks += block_count(range.count);
    return blocks;
}

/// The block of that number. A linear search is cheap: groups have few bodies.
inline BlockRange nth_block(std::span<const ParticleRange> ranges, std::uint32_t number) {
    std::uint32_t block = number;
    for (const ParticleRange& range : ranges) {
        const std::uint32_t blocks = block_count(range.count);
        if (block < blocks) {
            const std::uint32_t end = std::min(range.count, (block + 1) * block_size);
            return {range.first + block * block_size, range.first + end, number};
        }
        block -= blocks;
    }
    return {0, 0, number};
}

/// Calls body(BlockRange) for the blocks of all ranges, one range after the other.
template <class Body>
void for_ranges(Parallel& parallel, std::span<const ParticleRange> ranges, const Body& body) {
    parallel.blocks(block_count(ranges), [&](std::uint32_t block) { body(nth_block(ranges, block)); });
}

/// Sets partials[block] = map(BlockRange), and combines these from the left in block order.
/// Precondition: partials.size() >= block_count(ranges).
template <class T, class Map, class Combine>
T reduce_ranges(Parallel& parallel, std::span<const ParticleRange> ranges, std::span<T> partials, T initial,
                const Map& map, const Combine& combine) {
    for_ranges(parallel, ranges, [&](const BlockRange& range) { partials[range.block] = map(range); });
    for (const T& partial : partials.first(block_count(ranges))) initial = combine(initial, partial);
    return initial;
}

}  // namespace weft
