#include "collision/hash_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace weft {

namespace {

constexpr std::uint32_t min_buckets = 4;  // a run of three buckets must not meet itself around the table

std::uint32_t default_bucket_count(std::uint32_t particle_count) {
    return std::max(min_buckets, std::bit_ceil(2 * particle_count));
}

bool is_finite(const Vec4& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

bool is_finite(const Bounds& b) {
    return is_finite(Vec4{b.lower.x, b.lower.y, b.lower.z}) &&
           is_finite(Vec4{b.upper.x, b.upper.y, b.upper.z});
}

}  // namespace

HashGrid::HashGrid(std::uint32_t particle_count)
    : HashGrid(particle_count, default_bucket_count(particle_count)) {}

HashGrid::HashGrid(std::uint32_t particle_count, std::uint32_t bucket_count)
    : bucket_bits_(static_cast<std::uint32_t>(std::countr_zero(bucket_count))),
      starts_(bucket_count + run_length),
      entries_(particle_count),
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
HashGrid::Cells HashGrid::cells(const Bounds& bounds, float distance, float shift) const {
    constexpr float cells_limit = 1048576.0f;  // 2^20
    Bounds box = bounds;
    if (!is_finite(box)) {  // some particle flew off; the others are still best sorted around the origin
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
    sort(parallel, positions, [cells = cells_](const Vec4& p) { return cells.row_bucket(p.x, p.y, p.z); });
}

void HashGrid::build_cubes(Parallel& parallel, std::span<const Vec4> positions, const Bounds& bounds,
                           float distance, float shift) {
    cells_ = cells(bounds, distance, shift);
    sort(parallel, positions, [cells = cells_](const Vec4& p) { return cells.cube_bucket(p.x, p.y, p.z); });
}

// The table is cut into 2^part_bits parts of equally many buckets. Each block puts its particles in order of
// part, keeping their order; then each part sorts its own entries, which it reads block by block. A part's
// buckets, and so its slots, are its own: no two write the same memory, and the number of parts does not show
// in the result.
template <class BucketOf>
void HashGrid::sort(Parallel& parallel, std::span<const Vec4> positions, const BucketOf& bucket_of) {
    // Several parts per thread, to even out those that hold more than their share.
    const std::uint32_t wanted =
        std::bit_ceil(std::min(4 * static_cast<std::uint32_t>(parallel.width()), max_parts));
    const std::uint32_t part_bits =
        std::min(static_cast<std::uint32_t>(std::countr_zero(wanted)), bucket_bits_);

    const auto n = static_cast<std::uint32_t>(positions.size());
    const std::uint32_t mask = bucket_count() - 1;
    std::fill_n(&starts_[bucket_count()], run_length, n);  // the buckets past the table's end are empty
    parallel.ranges(n, [&](const BlockRange& range) {
        std::array<std::uint32_t, block_size> buckets;
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const std::uint32_t bucket = bucket_of(positions[i]);
            buckets[i - range.begin] = is_finite(positions[i]) ? bucket : i & mask;
        }
        partition_block(range, buckets.data(), part_bits);
    });
    parallel.blocks(1u << part_bits, [&](std::uint32_t part) { sort_part(positions, part, part_bits); });
}

void HashGrid::partition_block(const BlockRange& range, const std::uint32_t* buckets,
                               std::uint32_t part_bits) {
    const std::uint32_t count = range.end - range.begin;
    const std::uint32_t shift = bucket_bits_ - part_bits;
    std::uint16_t* const starts = &part_starts_[range.block * (max_parts + 1)];

    std::array<std::uint16_t, max_parts> next{};
    for (std::uint32_t k = 0; k < count; ++k) ++next[buckets[k] >> shift];
    std::uint16_t start = 0;
    for (std::uint32_t part = 0; part < 1u << part_bits; ++part) {
        starts[part] = start;
        start = static_cast<std::uint16_t>(start + next[part]);
        next[part] = starts[part];
    }
    starts[1u << part_bits] = start;
    for (std::uint32_t k = 0; k < count; ++k) {
        entries_[range.begin + next[buckets[k] >> shift]++] = {buckets[k], range.begin + k};
    }
}

template <class Visit>
void HashGrid::for_each_entry(std::uint32_t particle_count, std::uint32_t part, const Visit& visit) const {
    for (std::uint32_t block = 0; block < block_count(particle_count); ++block) {
        const std::uint16_t* const starts = &part_starts_[block * (max_parts + 1) + part];
        for (std::uint32_t k = starts[0]; k < starts[1]; ++k) visit(entries_[block * block_size + k]);
    }
}

void HashGrid::sort_part(std::span<const Vec4> positions, std::uint32_t part, std::uint32_t part_bits) {
    const auto n = static_cast<std::uint32_t>(positions.size());
    const std::uint32_t bucket_begin = part << (bucket_bits_ - part_bits);
    const std::uint32_t bucket_end = (part + 1) << (bucket_bits_ - part_bits);

    std::uint32_t slot_begin = 0;  // entries of the parts before this one
    for (std::uint32_t block = 0; block < block_count(n); ++block) {
        slot_begin += part_starts_[block * (max_parts + 1) + part];
    }

    // ends[b] counts bucket b, then is where its next particle goes, and so in the end is where it ends. That
    // is where bucket b + 1 starts, hence the shift by one; starts_[0] stays 0.
    std::uint32_t* const ends = starts_.data() + 1;
    std::fill(ends + bucket_begin, ends + bucket_end, 0u);
    for_each_entry(n, part, [&](const Entry& entry) { ++ends[entry.bucket]; });
    std::uint32_t slot = slot_begin;
    for (std::uint32_t bucket = bucket_begin; bucket < bucket_end; ++bucket) {
        const std::uint32_t count = ends[bucket];
        ends[bucket] = slot;
        slot += count;
    }
    for_each_entry(n, part, [&](const Entry& entry) { particles_[ends[entry.bucket]++] = entry.particle; });

    for (std::uint32_t s = slot_begin; s < slot; ++s) {
        const Vec4& p = positions[particles_[s]];
        x_[s] = p.x;
        y_[s] = p.y;
        z_[s] = p.z;
    }
}

HashGrid::Near HashGrid::near(float x, float y, float z) const noexcept {
    Near near;
    for (const std::uint32_t first : cells_.runs_near(x, y, z)) {
        near.ranges[near.count++] = run(first);
        if (wraps(first))
            near.ranges[near.count++] = {starts_[0], starts_[first + run_length - bucket_count()]};
    }
    return near;
}

void HashGrid::runs_of(const BlockRange& slots, Runs& runs) const noexcept {
    const Cells cells = cells_;
    const float *const x = &x_[slots.begin], *const y = &y_[slots.begin], *const z = &z_[slots.begin];
    const std::uint32_t count = slots.end - slots.begin;
    for (std::uint32_t k = 0; k < count; ++k) {
        const auto near = cells.runs_near(x[k], y[k], z[k]);
        runs[0][k] = near[0];
        runs[1][k] = near[1];
        runs[2][k] = near[2];
        runs[3][k] = near[3];
    }
}

std::size_t HashGrid::bytes() const noexcept {
    return starts_.bytes() + entries_.bytes() + part_starts_.bytes() + particles_.bytes() + x_.bytes() +
           y_.bytes() + z_.bytes();
}

}  // namespace weft
