#pragma once
// Timings in Chrome's trace event format, which Perfetto (ui.perfetto.dev) and chrome://tracing open.

#include <chrono>
#include <filesystem>
#include <span>

#include "weft/error.h"

namespace weft {

/// Something that ran from `begin` to `end` on the thread that drives the profiler.
struct TraceEvent {
    const char* name = "";
    std::chrono::steady_clock::time_point begin, end;
};

/// Complete events ("ph": "X") in microseconds since the earliest one. Error: the file cannot be written.
[[nodiscard]] Result<void> write_chrome_trace(const std::filesystem::path& file,
                                              std::span<const TraceEvent> events);

}  // namespace weft
