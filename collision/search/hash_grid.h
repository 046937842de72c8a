#pragma once
// Particles sorted by hashed cell: memory and time of O(n), however far the cloth is spread (Kang, section
// IV).

#include <array>
#include <cstdint>
#include <span>

#include "collision/search/cells.h"
#include "collision/search/grid_kernels.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

/// Slots [begin, end) of the sorted order.
struct SlotRange {
    std::uint32_t begin, end;
};

/// Particles and their positions, by slot.
struct SortedParticles {
    const std::uint32_t* particles;
    const float *x, *y, *z;
};

/// A counting sort of particles by bucket. A particle's place in the sorted order is its slot; inside a
/// bucket slots ascend with the particle's index, for any number of threads. Nothing is allocated after
/// construction.
///
/// Particles of one cell share a bucket; cells far apart may share one too, so what a range holds is a
/// candidate and must be tested. Particles with a coordinate that is not finite are spread over all buckets.
class HashGrid {
  public:
    /// Number of slots past the last one that may be read; they hold NaN, which is close to nothing.
    static constexpr std::uint32_t padding = 64;

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

    /// After build_cubes: the bucket of (x, y, z).
    [[nodiscard]] SlotRange own_bucket(float x, float y, float z) const noexcept {
        const std::uint32_t bucket = cells_.cube_bucket(x, y, z);
        return {starts_[bucket], starts_[bucket + 1]};
    }

    [[nodiscard]] Near near_in_bucket(float x, float y, float z) const noexcept {
        return {.ranges = {own_bucket(x, y, z)}, .count = 1};
    }

    /// Number of buckets in a run, which is named by its first bucket.
    static constexpr std::uint32_t run_length = 3;
    [[nodiscard]] const Cells& cells() const noexcept { return cells_; }
    /// Bucket b is the slots [starts()[b], starts()[b + 1]). Behind the table follow run_length empty
    /// buckets, so that a run that wraps around can be read up to the end of the table.
    [[nodiscard]] const std::uint32_t* starts() const noexcept { return starts_.data(); }

    [[nodiscard]] SortedParticles sorted() const noexcept {
        return {particles_.data(), x_.data(), y_.data(), z_.data()};
    }
    /// Particles and coordinates, by slot.
    [[nodiscard]] const std::uint32_t* particles() const noexcept { return particles_.data(); }
    [[nodiscard]] const float* x() const noexcept { return x_.data(); }
    [[nodiscard]] const float* y() const noexcept { return y_.data(); }
    [[nodiscard]] const float* z() const noexcept { return z_.data(); }

    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    static constexpr std::uint32_t max_parts = 64;

    [[nodiscard]] std::uint32_t bucket_count() const noexcept { return 1u << bucket_bits_; }
    [[nodiscard]] Cells cells(const Bounds& bounds, float distance, float shift) const;
    void sort(Parallel& parallel, std::span<const Vec4> positions, CellShape shape);
    void sort_part(std::span<const Vec4> positions, std::uint32_t part, std::uint32_t part_bits);
    template <class Visit>
    void for_each_entry(std::uint32_t particle_count, std::uint32_t part, const Visit& visit) const;

    Cells cells_;
    std::uint32_t bucket_bits_;
    AlignedBuffer<std::uint32_t> starts_;
    AlignedBuffer<std::uint32_t> entry_buckets_, entry_particles_;  // by block, part and particle
    AlignedBuffer<std::uint16_t> part_starts_;  // per block, where each part's entries start in it
    AlignedBuffer<std::uint32_t> particles_;    // by slot, as all below
    AlignedBuffer<float> x_, y_, z_;
};

}  // namespace weft
