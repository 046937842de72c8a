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
/// distance do not reach across the box, columns are wider and hold more that is not close. One particle far
/// off makes them as wide as that, and the search as long as testing all with all.
class SweepGrid {
  public:
    explicit SweepGrid(std::uint32_t particle_count);

    /// Sorts. `bounds` hold all positions that are finite.
    void build(Parallel& parallel, std::span<const Vec4> positions, const Bounds& bounds, float distance);

    /// Particles with finite positions: only these have slots.
    [[nodiscard]] std::uint32_t size() const noexcept { return finite_; }
    /// By slot. HashGrid::padding slots past the last one may be read; they are close to nothing.
    [[nodiscard]] SortedParticles sorted() const noexcept {
        return {particles_.data(), x_.data(), y_.data(), z_.data()};
    }

    /// What each slot of a block is to be tested with: in its own column and the eight around it the sweep
    /// cells within the distance. The source visits its own column from itself on and four others, so that it
    /// meets each pair once, and writes to both. Here a block writes its own particles' lists alone, so each
    /// pair is met from both sides: the source's five columns, and their mirror images.
    void find_ranges(const BlockRange& slots, SlotRanges& ranges) const;

    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    struct Entry {
        std::uint32_t key, particle;
    };
    static constexpr std::uint32_t radix = 256, digits = 4, sort_block = 2048;
    using Counts = std::array<std::uint32_t, radix>;

    /// coordinate -> cell, from 1 to `cells`.
    struct Axis {
        float Vec4::*coordinate;
        float lower, per_metre;
        float cells;
        [[nodiscard]] std::uint32_t at(const Vec4& p) const noexcept;
    };

    void choose_axes(const Bounds& bounds, float distance);
    [[nodiscard]] std::uint32_t key_of(const Vec4& p) const noexcept;
    bool sort_by(Parallel& parallel, std::uint32_t shift, const Entry* from, Entry* to);

    std::array<Axis, 3> axes_{};     // sweep, then the columns' two
    std::uint32_t sweep_cells_ = 0;  // to either side that the distance reaches
    std::uint32_t finite_ = 0;
    AlignedBuffer<Entry> entries_, other_entries_;
    AlignedBuffer<Counts> counts_;       // by block of the sort: how many of each digit, then where they go
    AlignedBuffer<std::uint32_t> keys_;  // by slot, as all below
    AlignedBuffer<std::uint32_t> particles_;
    AlignedBuffer<float> x_, y_, z_;
};

}  // namespace weft
