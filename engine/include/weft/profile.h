#pragma once
// Where the time of a step went.

#include <cstdint>
#include <span>

namespace weft {

/// One named stage of the step, in the order in which stages run. Times in milliseconds.
/// The percentiles are over the last `samples` steps (at most 256).
struct StageTime {
    const char* name = "";
    float last = 0;  ///< in the last step
    float p50 = 0, p95 = 0, p99 = 0, max = 0;
    std::uint32_t samples = 0;
};

}  // namespace weft
