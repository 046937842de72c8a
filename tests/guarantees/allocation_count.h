#pragma once
// Counts what goes through operator new, in all its forms and on all threads.
//
// oneTBB does not: it takes the memory of its tasks from tbbmalloc, once for each thread, and keeps it. That
// is the one allocator which "step() does not allocate" leaves out.

#include <cstdint>

namespace weft {

/// Allocations since the program started.
[[nodiscard]] std::uint64_t allocation_count() noexcept;

/// Bytes that are allocated now, as the allocator rounds them.
[[nodiscard]] std::int64_t allocated_bytes() noexcept;

}  // namespace weft
