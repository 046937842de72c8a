#pragma once
// Timings in Chrome's trace event format, which Perfetto (ui.perfetto.dev) and chrome://tracing open.

#include <filesystem>
#include <span>

#include "engine/profiling/trace_log.h"
#include "weft/error.h"

namespace weft {

/// Complete events ("ph": "X") in microseconds since the earliest one, on one track per thread. The track of
/// the thread that ran `driver` bears its name. Error: the file cannot be written.
[[nodiscard]] Result<void> write_chrome_trace(const std::filesystem::path& file,
                                              std::span<const TraceEvent> events, const char* driver);

}  // namespace weft
