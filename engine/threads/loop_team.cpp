#include "engine/threads/loop_team.h"

#include <chrono>

#include "engine/platform.h"

#if defined(_MSC_VER)
#include <intrin.h>
#elif defined(__x86_64__) || defined(__i386__)
#include <immintrin.h>
#endif

namespace weft {

namespace {

// A helper that has waited this long for the next loop lets others have its core.
constexpr std::chrono::microseconds watching{20};

void pause() {
#if defined(_M_ARM64)
    __yield();
#elif defined(__x86_64__) || defined(__i386__) || defined(_M_X64)
    _mm_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
}

}  // namespace

thread_local bool LoopTeam::inside_body_ = false;

// Invariant: a place's tag is the loop's number only from the time that the loop is posted until its blocks
// are done. A thread that raises `next` under that tag owns a block of the loop, and read it whole.
void LoopTeam::begin(const Loop& loop) {
    ++number_;
    Posted& posted = posted_[number_ % 2];
    posted.block_count.store(loop.block_count, std::memory_order_release);
    posted.body.store(loop.body, std::memory_order_release);
    posted.context.store(loop.context, std::memory_order_release);
    finished_.store(0, std::memory_order_relaxed);
    for (std::uint32_t place = 0; place < width(); ++place) {
        const std::uint64_t first = first_block(place, loop.block_count);
        places_[place].next.store(std::uint64_t{number_} << 32 | first, std::memory_order_release);
    }
    begun_.store(number_, std::memory_order_release);
}

void LoopTeam::take_blocks(std::uint32_t number, std::uint32_t own_place) {
    const Posted& posted = posted_[number % 2];
    const std::uint32_t block_count = posted.block_count.load(std::memory_order_acquire);
    const Executor::Body body = posted.body.load(std::memory_order_acquire);
    void* const context = posted.context.load(std::memory_order_acquire);
    std::uint32_t taken = 0;
    for (std::uint32_t k = 0; k < width(); ++k) {
        const std::uint32_t place = (own_place + k) % width(), end = first_block(place + 1, block_count);
        std::atomic<std::uint64_t>& next = places_[place].next;
        std::uint64_t value = next.load(std::memory_order_acquire);
        while (value >> 32 == number && static_cast<std::uint32_t>(value) < end) {
            if (!next.compare_exchange_weak(value, value + 1, std::memory_order_acq_rel)) continue;
            inside_body_ = true;
            body(context, static_cast<std::uint32_t>(value));
            inside_body_ = false;
            ++taken;
            value = next.load(std::memory_order_acquire);
        }
    }
    if (taken > 0) finished_.fetch_add(taken, std::memory_order_release);
}

// A helper that was interrupted within a block may need this thread's core: yield after a while.
void LoopTeam::await_end(std::uint32_t block_count) const {
    for (int spins = 0; finished_.load(std::memory_order_acquire) != block_count; ++spins) {
        if (spins < 2000)
            pause();
        else
            yield_thread();
    }
}

void LoopTeam::help(std::uint32_t place, Duration patience) {
    using Clock = std::chrono::steady_clock;
    std::uint32_t seen = 0;
    Clock::time_point last = Clock::now();
    while (!is_closed_.load(std::memory_order_relaxed)) {
        const std::uint32_t number = begun_.load(std::memory_order_acquire);
        if (number != seen) {
            take_blocks(number, place);
            seen = number;
            last = Clock::now();
            continue;
        }
        for (int spin = 0; spin < 16 && begun_.load(std::memory_order_relaxed) == seen; ++spin) pause();
        const Clock::duration idle = Clock::now() - last;
        if (idle > patience) break;
        if (idle > watching) yield_thread();
    }
    places_[place].is_taken.store(false, std::memory_order_release);
}

}  // namespace weft
