#include "collision/contact/pairs/incidence.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace weft {

namespace {

// Limits of blocks that move pairs to buckets: at most so many, of at least so many pairs, so that a block's
// counts, one for each bucket, are few beside its pairs.
constexpr std::uint32_t most_blocks = 64, least_pairs = 4096;

std::uint32_t pairs_per_block(std::size_t pairs) {
    return std::max(least_pairs, static_cast<std::uint32_t>((pairs + most_blocks - 1) / most_blocks));
}

/// Calls visit(particle, place) for the corners of a block's chosen pairs.
template <class Visit>
void for_each_corner(std::span<const FeaturePair> pairs, std::span<const std::uint8_t> chosen,
                     const BlockRange& block, const Visit& visit) {
    const auto visit_pair = [&](std::uint32_t pair) {
        for (std::uint32_t corner = 0; corner < 4; ++corner)
            visit(pairs[pair].corners[corner], 4 * pair + corner);
    };
    if (chosen.empty()) {
        for (std::uint32_t pair = block.begin; pair < block.end; ++pair) visit_pair(pair);
        return;
    }
    for (std::uint32_t pair = block.begin; pair < block.end;) {
        if (block.end - pair >= sizeof(std::uint64_t)) {  // few are chosen: skips eight at a time
            std::uint64_t eight;
            std::memcpy(&eight, &chosen[pair], sizeof eight);
            if (eight == 0) {
                pair += static_cast<std::uint32_t>(sizeof eight);
                continue;
            }
        }
        if (chosen[pair] != 0) visit_pair(pair);
        ++pair;
    }
}

}  // namespace

void PairIncidence::lay_out_rows(Scratch& scratch, std::size_t particles, std::size_t pairs) {
    buckets_ = block_count(static_cast<std::uint32_t>(particles));
    scratch.take(counts_, std::size_t{most_blocks} * buckets_);
    scratch.take(bucket_begin_, buckets_ + 1);
    scratch.take(bucket_rows_, buckets_ + 1);
    scratch.take(places_, 4 * pairs);
    scratch.take(particles_, std::min(particles, 4 * pairs));
    scratch.take(starts_, particles_.size() + 1);
    rows_ = 0;
}

// A radix sort of two digits, both stable: by block of particles, then within it.
void PairIncidence::build(Parallel& parallel, std::span<const FeaturePair> pairs,
                          std::span<const std::uint8_t> chosen) {
    rows_ = 0;
    if (pairs.empty()) return;
    count_by_bucket(parallel, pairs, chosen);
    move_to_buckets(parallel, pairs, chosen);
    sort_buckets(parallel);
}

void PairIncidence::count_by_bucket(Parallel& parallel, std::span<const FeaturePair> pairs,
                                    std::span<const std::uint8_t> chosen) {
    const auto size = static_cast<std::uint32_t>(pairs.size());
    const auto count_block = [&](const BlockRange& block) {
        std::uint32_t* const counts = counts_.data() + std::size_t{block.block} * buckets_;
        std::fill_n(counts, buckets_, 0u);
        for_each_corner(pairs, chosen, block,
                        [&](std::uint32_t particle, std::uint32_t) { ++counts[particle / block_size]; });
    };
    parallel.ranges(size, count_block, pairs_per_block(size));

    // Prefix sums, in order of buckets, and within a bucket in order of blocks of pairs.
    const std::uint32_t per_block = pairs_per_block(size), blocks = (size + per_block - 1) / per_block;
    std::uint32_t sum = 0;
    for (std::uint32_t bucket = 0; bucket < buckets_; ++bucket) {
        bucket_begin_[bucket] = sum;
        for (std::uint32_t block = 0; block < blocks; ++block) {
            std::uint32_t& count = counts_[std::size_t{block} * buckets_ + bucket];
            sum += std::exchange(count, sum);
        }
    }
    bucket_begin_[buckets_] = sum;
}

void PairIncidence::move_to_buckets(Parallel& parallel, std::span<const FeaturePair> pairs,
                                    std::span<const std::uint8_t> chosen) {
    const auto move_block = [&](const BlockRange& block) {
        std::uint32_t* const next = counts_.data() + std::size_t{block.block} * buckets_;
        for_each_corner(pairs, chosen, block, [&](std::uint32_t particle, std::uint32_t place) {
            entries_[next[particle / block_size]++] = {particle, place};
        });
    };
    parallel.ranges(static_cast<std::uint32_t>(pairs.size()), move_block, pairs_per_block(pairs.size()));
}

void PairIncidence::sort_buckets(Parallel& parallel) {
    using Counts = std::array<std::uint32_t, block_size>;  // by particle of a bucket
    const auto count = [&](std::uint32_t bucket) {
        Counts counts{};
        for (std::uint32_t e = bucket_begin_[bucket]; e < bucket_begin_[bucket + 1]; ++e) {
            ++counts[entries_[e].particle % block_size];
        }
        return counts;
    };
    parallel.blocks(buckets_, [&](std::uint32_t bucket) {
        bucket_rows_[bucket] = 0;
        if (bucket_begin_[bucket] == bucket_begin_[bucket + 1]) return;
        const Counts counts = count(bucket);
        bucket_rows_[bucket] = block_size - static_cast<std::uint32_t>(std::ranges::count(counts, 0u));
    });
    for (std::uint32_t bucket = 0; bucket < buckets_; ++bucket) {
        rows_ += std::exchange(bucket_rows_[bucket], rows_);
    }
    parallel.blocks(buckets_, [&](std::uint32_t bucket) {
        if (bucket_begin_[bucket] == bucket_begin_[bucket + 1]) return;
        Counts next = count(bucket);
        std::uint32_t row = bucket_rows_[bucket], sum = bucket_begin_[bucket];
        for (std::uint32_t i = 0; i < block_size; ++i) {
            if (next[i] == 0) continue;
            particles_[row] = bucket * block_size + i;
            starts_[row++] = sum;
            sum += std::exchange(next[i], sum);
        }
        for (std::uint32_t e = bucket_begin_[bucket]; e < bucket_begin_[bucket + 1]; ++e) {
            places_[next[entries_[e].particle % block_size]++] = entries_[e].place;
        }
    });
    starts_[rows_] = bucket_begin_[buckets_];
}

}  // namespace weft
