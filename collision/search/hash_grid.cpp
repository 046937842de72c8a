#include "collision/search/hash_grid.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "engine/error_text.h"

namespace weft {

namespace {

constexpr std::uint32_t min_buckets = 4;  // a run of three buckets must not overlap itself around the table

std::uint32_t default_bucket_count(std::uint32_t particle_count) {
    return std::max(min_buckets, std::bit_ceil(2 * particle_count));
}

}  // namespace

HashGrid::HashGrid(std::uint32_t particle_count)
    : HashGrid(particle_count, default_bucket_count(particle_count)) {}

HashGrid::HashGrid(std::uint32_t particle_count, std::uint32_t bucket_count)
    : bucket_bits_(static_cast<std::uint32_t>(std::countr_zero(bucket_count))),
      starts_(bucket_count + run_length),
      entry_buckets_(particle_count),
      entry_particles_(particle_count),
      part_starts_(block_count(particle_count) * (max_parts + 1)),
      particles_(particle_count + padding),
      x_(particle_count + padding),
      y_(particle_count + padding),
      z_(particle_count + padding) {
    for (std::uint32_t i = particle_count; i < particle_count + padding; ++i) {
        x_[i] = y_[i] = z_[i] = std::numeric_limits<float>::quiet_NaN();
    }
}

// An edge is a little more than the distance, by more than the rounding of (coordinate - origin) / edge in a
// box of this size: so two particles closer than the distance are never two cells apart, and there are at
// most 2^21 cells along an axis.
Cells HashGrid::cells(const Bounds& bounds, float distance, float shift) const {
    constexpr float cells_limit = 1048576.0f;  // 2^20
    Bounds box = bounds;
    if (!is_finite(box.lower) || !is_finite(box.upper)) {
        // A bound is not finite: the particles are then sorted around the origin.
        const float far = cells_limit * distance;
        box = {{-far, -far, -far}, {far, far, far}};
    }
    const float half_extent =
        std::max({0.0f, 0.5f * box.upper.x - 0.5f * box.lower.x, 0.5f * box.upper.y - 0.5f * box.lower.y,
                  0.5f * box.upper.z - 0.5f * box.lower.z});
    const float edge = distance * (1 + 1.0f / 65536) + half_extent / cells_limit;
    return {box.lower, 1 / edge, shift, bucket_count() - 1};
}

void HashGrid::build_rows(Parallel& parallel, std::span<const Vec4> positions, const Bounds& bounds,
                          float distance) {
    cells_ = cells(bounds, distance, 0);
    sort(parallel, positions, CellShape::row);
}

void HashGrid::build_cubes(Parallel& parallel, std::span<const Vec4> positions, const Bounds& bounds,
                           float distance, float shift) {
    cells_ = cells(bounds, distance, shift);
    sort(parallel, positions, CellShape::cube);
}

// The table is cut into 2^part_bits parts of equally many buckets. Each block puts its particles in order of
// part, keeping their order; then each part sorts its own entries, which it reads block by block. A part's
// buckets, and so its slots, are its own: no two write the same memory, and the number of parts does not
// affect the result.
void HashGrid::sort(Parallel& parallel, std::span<const Vec4> positions, CellShape shape) {
    // As many parts as threads: hashing makes them equal, and each reads every block's index.
    const std::uint32_t wanted =
        std::bit_ceil(std::min(static_cast<std::uint32_t>(parallel.width()), max_parts));
    const std::uint32_t part_bits =
        std::min(static_cast<std::uint32_t>(std::countr_zero(wanted)), bucket_bits_);

    const auto n = static_cast<std::uint32_t>(positions.size());
    std::fill_n(&starts_[bucket_count()], run_length, n);
    const GridEntries entries{entry_buckets_.data(), entry_particles_.data()};
    parallel.ranges(n, [&](const BlockRange& range) {
        BlockOfIndices buckets;
        find_buckets(cells_, shape, positions.subspan(range.begin, range.end - range.begin), range.begin,
                     buckets);
        partition_block(buckets, range, bucket_bits_ - part_bits, 1u << part_bits, entries,
                        &part_starts_[range.block * (max_parts + 1)]);
    });
    parallel.blocks(1u << part_bits, [&](std::uint32_t part) { sort_part(positions, part, part_bits); });
}

template <class Visit>
void HashGrid::for_each_entry(std::uint32_t particle_count, std::uint32_t part, const Visit& visit) const {
    for (std::uint32_t block = 0; block < block_count(particle_count); ++block) {
        const std::uint16_t* const starts = &part_starts_[block * (max_parts + 1) + part];
        const std::uint32_t begin = block * block_size + starts[0], end = block * block_size + starts[1];
        for (std::uint32_t k = begin; k < end; ++k) visit(k);
    }
}

void HashGrid::sort_part(std::span<const Vec4> positions, std::uint32_t part, std::uint32_t part_bits) {
    const auto n = static_cast<std::uint32_t>(positions.size());
    const std::uint32_t bucket_begin = part << (bucket_bits_ - part_bits);
    const std::uint32_t bucket_end = (part + 1) << (bucket_bits_ - part_bits);

    std::uint32_t slot_begin = 0, slot_end = 0;  // number of entries before this part, and up to its end
    for (std::uint32_t block = 0; block < block_count(n); ++block) {
        const std::uint16_t* const starts = &part_starts_[block * (max_parts + 1) + part];
        slot_begin += starts[0];
        slot_end += starts[1];
    }

    // ends[b] first counts bucket b, then is the slot of its next particle, and in the end that where it
    // ends. Bucket b + 1 starts there, hence the shift by one; starts_[0] stays 0.
    std::uint32_t* const ends = starts_.data() + 1;
    const std::uint32_t* const buckets = entry_buckets_.data();
    const std::uint32_t* const entries = entry_particles_.data();
    std::uint32_t* const particles = particles_.data();
    std::fill(ends + bucket_begin, ends + bucket_end, 0u);
    for_each_entry(n, part, [=](std::uint32_t k) { ++ends[buckets[k]]; });
    running_sum({ends + bucket_begin, ends + bucket_end}, slot_begin);
    for_each_entry(n, part, [=](std::uint32_t k) { particles[ends[buckets[k]]++] = entries[k]; });
    copy_sorted(positions, particles, slot_begin, slot_end, x_.data(), y_.data(), z_.data());
}

HashGrid::Near HashGrid::near(float x, float y, float z) const noexcept {
    Near near;
    for (const std::uint32_t first : cells_.runs_near(x, y, z)) {
        near.ranges[near.count++] = {starts_[first], starts_[first + run_length]};
        if (first + run_length > bucket_count())
            near.ranges[near.count++] = {starts_[0], starts_[first + run_length - bucket_count()]};
    }
    return near;
}

std::size_t HashGrid::bytes() const noexcept {
    return starts_.bytes() + entry_buckets_.bytes() + entry_particles_.bytes() + part_starts_.bytes() +
           particles_.bytes() + x_.bytes() + y_.bytes() + z_.bytes();
}

}  // namespace weft
