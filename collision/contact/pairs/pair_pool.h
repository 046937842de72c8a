#pragma once
// Room for the pairs that a search finds, until all are counted and each has its place in the list.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

#include "collision/contact/pairs/pairs.h"
#include "engine/memory/scratch.h"

namespace weft {

/// Chunks of pairs. Each block of a search takes chunks as it needs them, and links them to one another.
/// Which ones it gets depends on threads; which pairs are in them does not.
class PairPool {
  public:
    static constexpr std::uint32_t none = ~0u;

    /// Room for so many pairs, which so many lists have found.
    void lay_out(Scratch& scratch, std::size_t pairs, std::size_t lists) {
        const std::size_t chunks = pairs / chunk_size + lists;  // a list's last chunk is partly empty
        scratch.take_few(pairs_, chunks * chunk_size);
        scratch.take_few(next_, chunks);
    }
    /// Frees all chunks.
    void begin() noexcept { taken_ = 0; }

    /// The next free chunk; none, if all are taken. It becomes the one after `last`, unless that is none.
    [[nodiscard]] std::uint32_t take(std::uint32_t last) noexcept {
        const std::uint32_t chunk = std::atomic_ref(taken_).fetch_add(1, std::memory_order_relaxed);
        if (chunk >= next_.size()) return none;
        if (last != none) next_[last] = chunk;
        return chunk;
    }
    [[nodiscard]] std::span<FeaturePair> room(std::uint32_t chunk) noexcept {
        return pairs_.span().subspan(std::size_t{chunk} * chunk_size, chunk_size);
    }
    /// Copies the first pairs of a list whose first chunk is this one.
    void copy(std::uint32_t chunk, std::span<FeaturePair> to) const noexcept {
        for (; !to.empty(); chunk = next_[chunk]) {
            const std::size_t count = std::min<std::size_t>(to.size(), chunk_size);
            std::copy_n(pairs_.data() + std::size_t{chunk} * chunk_size, count, to.data());
            to = to.subspan(count);
        }
    }

  private:
    static constexpr std::uint32_t chunk_size = 64;

    ScratchArray<FeaturePair> pairs_;
    ScratchArray<std::uint32_t> next_;  // by chunk
    std::uint32_t taken_ = 0;           // chunks asked for, by all threads
};

/// A block's pairs of one kind, during a search: all that it finds are counted, and at `enough` the search
/// for them ends.
class PairsOfBlock {
  public:
    PairsOfBlock() = default;
    /// Keeps the pairs in chunks of a pool.
    explicit PairsOfBlock(PairPool& pool) : pool_(&pool) {}
    /// Keeps as many as there is room for, and ends there.
    explicit PairsOfBlock(std::span<FeaturePair> room)
        : enough(static_cast<std::uint32_t>(room.size())), to_(room.data()), end_(to_ + room.size()) {}

    void add(const FeaturePair& pair) noexcept {
        ++count;
        if (to_ == end_ && !grow()) return;
        *to_++ = pair;
    }
    [[nodiscard]] bool has_enough() const noexcept { return count >= enough; }
    /// The first chunk. None: there are no pairs, or not all of them had room in the pool.
    [[nodiscard]] std::uint32_t first_chunk() const noexcept { return first_; }

    std::uint32_t count = 0, enough = ~0u;

  private:
    [[nodiscard]] bool grow() noexcept {
        if (pool_ == nullptr) return false;
        last_ = pool_->take(last_);
        if (last_ == PairPool::none) {
            first_ = PairPool::none;
            pool_ = nullptr;
            return false;
        }
        if (first_ == PairPool::none) first_ = last_;
        to_ = pool_->room(last_).data();
        end_ = to_ + pool_->room(last_).size();
        return true;
    }

    PairPool* pool_ = nullptr;
    FeaturePair *to_ = nullptr, *end_ = nullptr;
    std::uint32_t first_ = PairPool::none, last_ = PairPool::none;
};

}  // namespace weft
