#pragma once
// The host's hooks, as the library calls them.

#include <cstddef>

#include "weft/hooks.h"

namespace weft {

inline constexpr std::size_t memory_alignment = 64;

/// Aligned memory, counted in memory_in_use(). Calls refuse_memory() if there is none.
[[nodiscard]] void* take_memory(std::size_t bytes);
void give_memory_back(void* memory, std::size_t bytes) noexcept;

/// Sends one line to the host, cut at 255 characters.
[[gnu::format(printf, 2, 3)]] void log_line(LogLevel level, const char* format, ...) noexcept;
[[nodiscard]] bool is_logged() noexcept;  ///< else lines are dropped

void begin_zone(const char* name) noexcept;
void end_zone(const char* name) noexcept;

[[noreturn]] void fail_assertion(const char* condition, const char* file, int line) noexcept;

}  // namespace weft

#ifdef NDEBUG
#define WEFT_ASSERT(condition) static_cast<void>(0)
#else
#define WEFT_ASSERT(condition) \
    ((condition) ? static_cast<void>(0) : ::weft::fail_assertion(#condition, __FILE__, __LINE__))
#endif
