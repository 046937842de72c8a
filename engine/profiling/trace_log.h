#pragma once
// A log of events with their threads and times, filled by any number of threads at once, without locks.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

#include "weft/error.h"

namespace weft {

/// A stage, or one thread's share of a loop, from `begin` to `end`.
struct TraceEvent {
    const char* name = "";
    std::uint32_t thread = 0;  ///< thread_number() of that thread
    std::uint32_t blocks = 0;  ///< blocks of a parallel loop that the thread ran; 0: not part of a loop
    std::chrono::steady_clock::time_point begin, end;
};

/// Number of the calling thread: 1 for the first in this process that asks, then 2, 3, ...
[[nodiscard]] std::uint32_t thread_number() noexcept;

class TraceLog {
  public:
    using Time = std::chrono::steady_clock::time_point;

    static constexpr std::size_t most_events = std::size_t{1} << 26;

    /// Clears the log and keeps up to `max_events` from here on; later events are dropped. Allocates; nothing
    /// may be added meanwhile. Error, which leaves the log as it was: max_events beyond [1, most_events], or
    /// no memory.
    Result<void> start(std::size_t max_events);
    [[nodiscard]] bool is_on() const noexcept { return !events_.empty(); }

    void add(const char* name, Time begin, Time end) noexcept;
    /// A block of a parallel loop, numbered by new_loop(). The blocks that one thread runs of a loop are one
    /// event.
    void add_block(std::uint64_t loop, const char* name, Time begin, Time end) noexcept;
    [[nodiscard]] static std::uint64_t new_loop() noexcept;

    /// Events in the order in which they were appended. Nothing may be added meanwhile.
    [[nodiscard]] std::span<const TraceEvent> events() const noexcept;

  private:
    TraceEvent* append(const TraceEvent& event) noexcept;  // null: full

    std::vector<TraceEvent> events_;
    std::atomic<std::size_t> appended_ = 0;  // may run past the size
};

/// Names the calling thread's activity, for the parallel loops that it starts meanwhile.
class NamedActivity {
  public:
    explicit NamedActivity(const char* name) noexcept;
    ~NamedActivity();
    NamedActivity(const NamedActivity&) = delete;
    NamedActivity& operator=(const NamedActivity&) = delete;

    /// The innermost activity of the calling thread; "loop" if there is none.
    [[nodiscard]] static const char* current() noexcept;

  private:
    const char* outer_;
};

}  // namespace weft
