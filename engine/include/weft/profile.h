#pragma once
// The time that each stage of a step took.

#include <cstdint>
#include <span>

namespace weft {

/// One named stage of the step. Times in milliseconds; the percentiles are over the last `samples` steps (at
/// most 256).
///
/// Stages form a tree. Rows stand in the order in which stages run, each before its parts; the whole step is
/// the last row. A stage's time is that of the thread that drives it, and those of small cloths, which are
/// stepped side by side on several threads, add up: only the step's own row is wall time.
struct StageTime {
    const char* name = "";
    /// 0 for the whole step, 1 for its parts, 2 for theirs: a row is part of the nearest row before it of a
    /// lesser depth.
    int depth = 0;
    float last = 0;  ///< in the last step
    float p50 = 0, p95 = 0, p99 = 0, max = 0;
    std::uint32_t samples = 0;
};

}  // namespace weft
