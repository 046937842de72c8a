#pragma once
// The one parallel primitive: a loop over fixed blocks.
//
// Invariant that buys determinism: how [0, n) is cut into blocks depends on n alone, a body knows its block
// and never its thread, no two bodies write the same element, and reductions add one partial per block in
// block order. So the bytes of every result are the same for any number of threads, and for the serial
// executor.

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>

#include "engine/profiling/trace_log.h"
#include "weft/executor.h"

namespace weft {

class HostTeam;

/// Elements per block. 256 particles of 16 bytes are 4 KiB of each buffer: small enough to balance 4 000
/// particles over 8 threads, large enough to hide the cost of handing a block out.
inline constexpr std::uint32_t block_size = 256;

constexpr std::uint32_t block_count(std::uint32_t n) {
    return (n + block_size - 1) / block_size;
}

/// A half-open range of elements and the index of the block that it is.
struct BlockRange {
    std::uint32_t begin, end, block;
};

class Parallel {
  public:
    /// A oneTBB arena of `threads` threads, the caller's among them, or of as many as oneTBB has: one per
    /// core, unless the host has set another limit. One thread runs everything on the caller's. Precondition:
    /// 1 <= threads <= 256.
    explicit Parallel(int threads);
    /// The host's threads, which run loops within lend() only. Precondition: executor.run is set,
    /// 1 <= executor.width <= 256.
    explicit Parallel(const Executor& executor);
    ~Parallel();
    Parallel(Parallel&&) noexcept;
    Parallel& operator=(Parallel&&) noexcept;

    /// Threads that work is spread over: for sizing partitions whose cut cannot show in a result.
    [[nodiscard]] int width() const noexcept { return width_; }

    /// Records in `log`, while it is on, which thread ran which blocks and when, under the NamedActivity of
    /// the thread that began the loop. Null ends it. The log must outlive the loops.
    void trace_to(TraceLog* log) noexcept { log_ = log; }

    /// Runs step(). A host's executor is called for it, once: the step runs on one of its threads, and its
    /// loops on all of them. A lend() within a step is a part of that step. Neither may throw.
    template <class Step>
    void lend(const Step& step) noexcept {
        lend([](void* context) { (*static_cast<const Step*>(context))(); }, const_cast<Step*>(&step));
    }

    /// body(block) for every block in [0, count). Bodies must not throw.
    template <class Body>
    void blocks(std::uint32_t count, const Body& body) {
        if (count <= 1 || width_ == 1) {
            for (std::uint32_t block = 0; block < count; ++block) body(block);
            return;
        }
        run(
            count,
            [](void* context, std::uint32_t block) noexcept { (*static_cast<const Body*>(context))(block); },
            const_cast<Body*>(&body));
    }

    /// body(BlockRange) for the blocks of [0, n), of `size` elements each. Take a smaller size where an
    /// element takes longer than a particle.
    template <class Body>
    void ranges(std::uint32_t n, const Body& body, std::uint32_t size = block_size) {
        blocks((n + size - 1) / size, [&](std::uint32_t block) {
            body(BlockRange{block * size, std::min(n, (block + 1) * size), block});
        });
    }

    /// Ordered reduction over [0, n): partials[block] = map(BlockRange), then combined from the left in block
    /// order. Precondition: partials.size() >= block_count(n).
    template <class T, class Map, class Combine>
    T reduce(std::uint32_t n, std::span<T> partials, T initial, const Map& map, const Combine& combine) {
        ranges(n, [&](const BlockRange& range) { partials[range.block] = map(range); });
        for (const T& partial : partials.first(block_count(n))) initial = combine(initial, partial);
        return initial;
    }

  private:
    class Arena;

    void lend(void (*step)(void* context), void* context) noexcept;
    void run(std::uint32_t block_count, Executor::Body body, void* context);
    void spread(std::uint32_t block_count, Executor::Body body, void* context);

    int width_ = 1;
    std::unique_ptr<Arena> arena_;  // one of the two, unless one thread does all
    std::unique_ptr<HostTeam> host_;
    TraceLog* log_ = nullptr;
};

}  // namespace weft
