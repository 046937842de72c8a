#pragma once
// Counts what goes through operator new, in all its forms and on all threads, and lets memory run out there.
//
// oneTBB does not: it takes the memory of its tasks from tbbmalloc, once for each thread, and keeps it. That
// is the one allocator which "step() does not allocate" leaves out.

#include <cstdint>

namespace weft {

/// Allocations since the program started.
[[nodiscard]] std::uint64_t allocation_count() noexcept;

/// Bytes that are allocated now, as the allocator rounds them.
[[nodiscard]] std::int64_t allocated_bytes() noexcept;

/// While it lives, `allowed` allocations are granted and the next one is refused: that one alone, or it and
/// all that follow. One at a time.
class MemoryRunsOut {
  public:
    enum class For { one, good };
    MemoryRunsOut(std::uint64_t allowed, For how_long) noexcept;
    ~MemoryRunsOut();
    MemoryRunsOut(const MemoryRunsOut&) = delete;
    MemoryRunsOut& operator=(const MemoryRunsOut&) = delete;

    /// Whether any was refused.
    [[nodiscard]] bool happened() const noexcept;
};

}  // namespace weft
