#pragma once
// The most that the machine can do: the roofs of Williams, Waterman and Patterson, "Roofline", 2009.

#include <cstddef>
#include <vector>

namespace weft::bench {

/// How fast a working set of that size is read again and again, by all threads together.
struct ReadRate {
    std::size_t bytes;  ///< working set, of all threads
    double bytes_per_second;
};

struct Roof {
    const char* target;  ///< Highway's, that the vectors are of
    double flops;        ///< fused multiply-adds in single precision, per second, each counted as two
    std::vector<ReadRate> reads;  ///< from the smallest working set to the largest

    /// The least time for that traffic by a kernel whose scene takes `working_set` bytes [s].
    [[nodiscard]] double least_seconds(double bytes, double flop_count, double working_set) const;
};

/// Takes some seconds.
[[nodiscard]] Roof measure_roof(int threads);

}  // namespace weft::bench
