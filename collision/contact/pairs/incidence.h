#pragma once
// Incidence of particles and pairs, as compressed rows: contributions of pairs to particles are gathered, in
// an order that does not depend on threads, and never scattered.

#include <cstdint>
#include <span>

#include "collision/contact/pairs/pairs.h"
#include "engine/memory/scratch.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

/// One row for each particle that is a corner of a pair, rows in ascending order of particles. A row's places
/// are 4 * pair + corner, ascending. Particles without pairs cost nothing but their share of a block.
class PairIncidence {
  public:
    /// Reserves memory for so many pairs of so many particles.
    void lay_out(Scratch& scratch, std::size_t particles, std::size_t pairs) {
        lay_out_rows(scratch, particles, pairs);
        lay_out_build(scratch, pairs);
    }
    /// lay_out() in two parts: the rows, and memory that only build() uses.
    void lay_out_rows(Scratch& scratch, std::size_t particles, std::size_t pairs);
    void lay_out_build(Scratch& scratch, std::size_t pairs) { scratch.take(entries_, 4 * pairs); }

    /// Builds the rows of the pairs for which chosen[pair] is not zero, or of all if `chosen` is empty.
    /// Preconditions: lay_out() has reserved for so many pairs and for particles above every corner.
    void build(Parallel& parallel, std::span<const FeaturePair> pairs, std::span<const std::uint8_t> chosen);

    [[nodiscard]] std::uint32_t rows() const noexcept { return rows_; }
    [[nodiscard]] std::uint32_t particle(std::uint32_t row) const noexcept { return particles_[row]; }
    /// Index of a row's first place among all rows' places.
    [[nodiscard]] std::uint32_t start(std::uint32_t row) const noexcept { return starts_[row]; }
    /// Particles and starts of all rows, for kernels.
    [[nodiscard]] std::span<const std::uint32_t> particles() const noexcept {
        return particles_.span().first(rows_);
    }
    [[nodiscard]] std::span<const std::uint32_t> starts() const noexcept {
        return starts_.span().first(rows_ + 1);
    }
    [[nodiscard]] std::span<const std::uint32_t> places(std::uint32_t row) const noexcept {
        return places_.span().subspan(starts_[row], starts_[row + 1] - starts_[row]);
    }

  private:
    struct Entry {
        std::uint32_t particle, place;
    };

    void count_by_bucket(Parallel& parallel, std::span<const FeaturePair> pairs,
                         std::span<const std::uint8_t> chosen);
    void move_to_buckets(Parallel& parallel, std::span<const FeaturePair> pairs,
                         std::span<const std::uint8_t> chosen);
    void sort_buckets(Parallel& parallel);

    std::uint32_t buckets_ = 0;  // number of buckets, of block_size particles each
    std::uint32_t rows_ = 0;
    ScratchArray<std::uint32_t> counts_;        // by block of pairs and bucket; then indices to write at
    ScratchArray<std::uint32_t> bucket_begin_;  // first entry of each bucket
    ScratchArray<std::uint32_t> bucket_rows_;   // number of a bucket's rows, then its first
    ScratchArray<Entry> entries_;               // sorted by bucket
    ScratchArray<std::uint32_t> places_, particles_, starts_;
};

}  // namespace weft
