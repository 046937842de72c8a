#pragma once
// Threads that share loops over blocks, without a lock: while a step runs, helpers watch for its next loop
// instead of being sent for, so that a loop costs a fraction of a microsecond.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <vector>

#include "weft/executor.h"

namespace weft {

/// One thread at a time runs loops; helpers, one to a place, take blocks of them. The runner waits for no
/// helper that has not begun a block, so helpers may come late, leave, or never come.
class LoopTeam {
  public:
    using Duration = std::chrono::steady_clock::duration;

    /// `width` >= 2 threads, the runner's among them, which has place 0.
    explicit LoopTeam(std::uint32_t width) : places_(width) {}

    /// Runs all blocks. From within a body: on the calling thread. `send(place)` is called for each helper
    /// that the loop can use and that is not there: it has some thread call help(place) soon and returns
    /// true, or false if none can come.
    template <class Send>
    void run(std::uint32_t block_count, Executor::Body body, void* context, const Send& send) {
        if (inside_body_) {
            for (std::uint32_t block = 0; block < block_count; ++block) body(context, block);
            return;
        }
        begin({block_count, body, context});
        const std::uint32_t useful = block_count < width() ? block_count : width();
        for (std::uint32_t place = 1; place < useful; ++place) {
            std::atomic<bool>& is_taken = places_[place].is_taken;  // set by this thread alone
            if (is_taken.load(std::memory_order_acquire)) continue;
            is_taken.store(true, std::memory_order_relaxed);
            if (!send(place)) is_taken.store(false, std::memory_order_relaxed);
        }
        take_blocks(number_, 0);
        await_end(block_count);
    }

    /// Takes blocks of loop after loop, until close(), or until none has begun for longer than `patience`.
    void help(std::uint32_t place, Duration patience);
    /// Helpers leave, and those that come later leave at once.
    void close() { is_closed_.store(true, std::memory_order_relaxed); }
    /// Takes close() back. Precondition: all helpers have left.
    void open() { is_closed_.store(false, std::memory_order_relaxed); }

  private:
    struct Loop {
        std::uint32_t block_count;
        Executor::Body body;
        void* context;
    };
    /// Each thread starts with blocks of its own, the same in every loop of as many, so that data that it
    /// wrote is still in its cache. Then it takes blocks that others have left.
    struct alignas(64) Place {
        std::atomic<std::uint64_t> next = 0;  // number of the loop << 32 | next of the place's blocks
        std::atomic<bool> is_taken = false;
    };
    /// The loop in work, by parity of its number. A late helper may read one while the next but one is
    /// written. It then finds other loops' tags at all places, because these were written before.
    struct Posted {
        std::atomic<std::uint32_t> block_count;
        std::atomic<Executor::Body> body;
        std::atomic<void*> context;
    };

    [[nodiscard]] std::uint32_t width() const { return static_cast<std::uint32_t>(places_.size()); }
    [[nodiscard]] std::uint32_t first_block(std::uint32_t place, std::uint32_t block_count) const {
        return static_cast<std::uint32_t>(std::uint64_t{place} * block_count / width());
    }
    void begin(const Loop& loop);
    void take_blocks(std::uint32_t number, std::uint32_t own_place);
    void await_end(std::uint32_t block_count) const;

    static thread_local bool inside_body_;

    std::vector<Place> places_;
    Posted posted_[2] = {};
    std::uint32_t number_ = 0;                             // number of the latest loop; the runner's own
    alignas(64) std::atomic<std::uint32_t> begun_ = 0;     // the same, for helpers to watch
    alignas(64) std::atomic<std::uint32_t> finished_ = 0;  // blocks of the loop in work
    std::atomic<bool> is_closed_ = false;
};

}  // namespace weft
