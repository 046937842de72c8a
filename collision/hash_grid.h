#pragma once
// Particles sorted by hashed cell: memory and time of O(n), however far the cloth is spread (Kang, section
// IV).

#include <array>
#include <cstdint>
#include <span>

#include "engine/aligned_buffer.h"
#include "engine/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

/// Slots [begin, end) of the sorted order.
struct SlotRange {
    std::uint32_t begin, end;
};

/// A counting sort of particles by bucket. A particle's place in the sorted order is its slot; inside a
/// bucket slots ascend with the particle's index, for any number of threads. Nothing is allocated after
/// construction.
///
/// Particles of one cell share a bucket; cells far apart may share one too, so what a range holds is a
/// candidate and must be tested. Particles with a coordinate that is not finite are spread over all buckets.
class HashGrid {
  public:
    /// So many slots past the last one may be read; they hold NaN, which is close to nothing.
    static constexpr std::uint32_t padding = 8;

    explicit HashGrid(std::uint32_t particle_count);
    /// `bucket_count`: a power of two, at least 4.
    HashGrid(std::uint32_t particle_count, std::uint32_t bucket_count);

    /// Sorts for near(): every particle closer than `distance` will be found. `bounds` should hold the
    /// positions; a wrong box costs time only.
    void build_rows(Parallel& parallel, std::span<const Vec4> positions, const Bounds& bounds,
                    float distance);

    /// Kang's grid: cubes of edge `distance`, shifted by `shift` of an edge on each axis.
    void build_cubes(Parallel& parallel, std::span<const Vec4> positions, const Bounds& bounds,
                     float distance, float shift);

    /// Up to eight ranges; usually four, since a run is cut in two only where it wraps around the table.
    struct Near {
        std::array<SlotRange, 8> ranges;
        std::uint32_t count = 0;
    };
    /// After build_rows: ranges that hold every particle closer than the distance to (x, y, z), the point's
    /// own row first. A particle may be in several of them.
    [[nodiscard]] Near near(float x, float y, float z) const noexcept;

    /// A run is three buckets; it is named by its first.
    static constexpr std::uint32_t run_length = 3;
    using Runs = std::array<std::array<std::uint32_t, block_size>, 4>;
    /// After build_rows: the four runs of each particle of a block of slots, from which near() takes its
    /// ranges.
    void runs_of(const BlockRange& slots, Runs& runs) const noexcept;
    /// The slots of a run, or of what there is of it before the end of the table.
    [[nodiscard]] SlotRange run(std::uint32_t first) const noexcept {
        return {starts_[first], starts_[first + run_length]};
    }
    [[nodiscard]] bool wraps(std::uint32_t first) const noexcept {
        return first + run_length > bucket_count();
    }

    /// After build_cubes: the bucket of (x, y, z).
    [[nodiscard]] SlotRange own_bucket(float x, float y, float z) const noexcept;

    /// By slot.
    [[nodiscard]] const std::uint32_t* particles() const noexcept { return particles_.data(); }
    [[nodiscard]] const float* x() const noexcept { return x_.data(); }
    [[nodiscard]] const float* y() const noexcept { return y_.data(); }
    [[nodiscard]] const float* z() const noexcept { return z_.data(); }

    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    [[nodiscard]] std::uint32_t bucket_count() const noexcept { return 1u << bucket_bits_; }

    /// Where cells lie, and the buckets of a point. A value of its own, so that loops can hold it in
    /// registers.
    struct Cells {
        Vec3 origin;
        float per_metre = 0;
        float shift = 0;
        std::uint32_t mask = 0;  // buckets - 1

        /// Counted from zero and never above 2^22, whatever the coordinate.
        [[nodiscard]] std::uint32_t at(float coordinate, float from) const noexcept;
        [[nodiscard]] std::uint32_t row_bucket(float x, float y, float z) const noexcept;
        [[nodiscard]] std::uint32_t cube_bucket(float x, float y, float z) const noexcept;
        [[nodiscard]] std::array<std::uint32_t, 4> runs_near(float x, float y, float z) const noexcept;
    };
    /// A particle on its way to its slot.
    struct Entry {
        std::uint32_t bucket, particle;
    };
    static constexpr std::uint32_t max_parts = 64;

    [[nodiscard]] Cells cells(const Bounds& bounds, float distance, float shift) const;

    template <class BucketOf>
    void sort(Parallel& parallel, std::span<const Vec4> positions, const BucketOf& bucket_of);
    void partition_block(const BlockRange& range, const std::uint32_t* buckets, std::uint32_t part_bits);
    void sort_part(std::span<const Vec4> positions, std::uint32_t part, std::uint32_t part_bits);
    template <class Visit>
    void for_each_entry(std::uint32_t particle_count, std::uint32_t part, const Visit& visit) const;

    Cells cells_;
    std::uint32_t bucket_bits_;
    AlignedBuffer<std::uint32_t> starts_;       // bucket b is the slots [starts_[b], starts_[b + 1])
    AlignedBuffer<Entry> entries_;              // by block; inside a block by part, then by particle
    AlignedBuffer<std::uint16_t> part_starts_;  // per block, where each part's entries start in it
    AlignedBuffer<std::uint32_t> particles_;    // by slot, as all below
    AlignedBuffer<float> x_, y_, z_;
};

namespace hash_grid_detail {

/// Odd multipliers spread neighbouring cells, the finaliser mixes their bits: a linear hash would put the
/// rows of a folded sheet on top of one another.
inline std::uint32_t mix(std::uint32_t bits) noexcept {
    bits = (bits ^ (bits >> 15)) * 0x2C1B3C6Du;
    return bits ^ (bits >> 13);
}
inline std::uint32_t row_hash(std::uint32_t y, std::uint32_t z) noexcept {
    return mix(y * 0x9E3779B1u ^ z * 0x85EBCA77u);
}

}  // namespace hash_grid_detail

inline std::uint32_t HashGrid::Cells::at(float coordinate, float from) const noexcept {
    constexpr float limit = 4194304.0f;  // 2^22: exact as a float, far from overflow as an int
    const float cell = (coordinate - from) * per_metre + shift;
    return static_cast<std::uint32_t>(
        static_cast<std::int32_t>(cell > 0 ? (cell < limit ? cell : limit) : 0));
}

// A cell is one edge along x and two along y and z; its bucket is (x + H(y, z)) mod the number of buckets.
// Hence a cell and its two neighbours along x are one run of three buckets, and along y and z only the
// neighbour on the side of the point's half of its cell can be within an edge: four runs in all.
inline std::array<std::uint32_t, 4> HashGrid::Cells::runs_near(float x, float y, float z) const noexcept {
    const std::uint32_t left = at(x, origin.x) - 1;
    const std::uint32_t half_y = at(y, origin.y), half_z = at(z, origin.z);
    const std::uint32_t cell_y = half_y >> 1, cell_z = half_z >> 1;
    const std::uint32_t other_y = cell_y - 1 + 2 * (half_y & 1), other_z = cell_z - 1 + 2 * (half_z & 1);
    using hash_grid_detail::row_hash;
    return {(left + row_hash(cell_y, cell_z)) & mask, (left + row_hash(other_y, cell_z)) & mask,
            (left + row_hash(cell_y, other_z)) & mask, (left + row_hash(other_y, other_z)) & mask};
}

inline SlotRange HashGrid::own_bucket(float x, float y, float z) const noexcept {
    const std::uint32_t bucket = cells_.cube_bucket(x, y, z);
    return {starts_[bucket], starts_[bucket + 1]};
}

inline std::uint32_t HashGrid::Cells::row_bucket(float x, float y, float z) const noexcept {
    const std::uint32_t row = hash_grid_detail::row_hash(at(y, origin.y) >> 1,  //
                                                         at(z, origin.z) >> 1);
    return (at(x, origin.x) + row) & mask;
}

inline std::uint32_t HashGrid::Cells::cube_bucket(float x, float y, float z) const noexcept {
    const std::uint32_t row = hash_grid_detail::row_hash(at(y, origin.y), at(z, origin.z));
    return hash_grid_detail::mix(at(x, origin.x) * 0xC2B2AE3Du ^ row) & mask;
}

}  // namespace weft
