#pragma once
// Particles sorted along the longest side of their box, in columns (NVIDIA NvCloth, "Self Collision").

#include <array>
#include <cstdint>
#include <span>

#include "collision/search/search_kernels.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

/// A radix sort of particles by 32-bit keys: along the sweep axis, the box's longest, 65 533 cells in the low
/// sixteen bits; across it a grid of at most 253 x 253 columns, no narrower than the distance, a byte for
/// each axis. The first and last cell of each axis stay empty, so that a neighbour's key is the own one plus
/// a constant. The order is the same for any number of threads. Nothing is allocated after construction.
///
/// Every pair closer than the distance is among the candidates, whatever the extent: where 253 columns of the
/// distance do not reach across the box, columns are wider and hold more that is not close. One distant
/// particle makes them so wide that the search takes as long as testing all pairs.
class SweepGrid {
  public:
    explicit SweepGrid(std::uint32_t particle_count);

    /// Sorts the particles. `bounds` hold all positions that are finite.
    void build(Parallel& parallel, std::span<const Vec4> positions, const Bounds& bounds, float distance);

    /// Number of particles with finite positions: only these have slots.
    [[nodiscard]] std::uint32_t size() const noexcept { return finite_; }
    /// Particles by slot. HashGrid::padding slots past the last may be read; they are close to nothing.
    [[nodiscard]] SortedParticles sorted() const noexcept {
        return {particles_.data(), x_.data(), y_.data(), z_.data()};
    }

    /// Finds the candidates of each slot of a block: in its own column and the eight around it, the sweep
    /// cells within the distance. The source visits its own column from the slot on and four others: it finds
    /// each pair once, and writes to both particles. Here a block writes only its own particles' lists, so
    /// each pair is found from both sides: in the source's five columns, and in their mirror images.
    void find_ranges(const BlockRange& slots, SlotRanges& ranges) const;

    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    struct Entry {
        std::uint32_t key, particle;
    };
    static constexpr std::uint32_t radix = 256, digits = 4, sort_block = 2048;
    using Counts = std::array<std::uint32_t, radix>;

    /// Maps a coordinate to a cell, from 1 to `cells`.
    struct Axis {
        float Vec4::*coordinate;
        float lower, per_metre;
        float cells;
        [[nodiscard]] std::uint32_t at(const Vec4& p) const noexcept;
    };

    void choose_axes(const Bounds& bounds, float distance);
    [[nodiscard]] std::uint32_t key_of(const Vec4& p) const noexcept;
    bool sort_by(Parallel& parallel, std::uint32_t shift, const Entry* from, Entry* to);

    std::array<Axis, 3> axes_{};     // the sweep axis, then the columns' two
    std::uint32_t sweep_cells_ = 0;  // sweep cells within the distance, to either side
    std::uint32_t finite_ = 0;
    AlignedBuffer<Entry> entries_, other_entries_;
    AlignedBuffer<Counts> counts_;  // by block of the sort: counts of each digit, then places to write at
    AlignedBuffer<std::uint32_t> keys_;  // by slot, as all below
    AlignedBuffer<std::uint32_t> particles_;
    AlignedBuffer<float> x_, y_, z_;
};

}  // namespace weft
