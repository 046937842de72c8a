#pragma once

#include <time.h>

namespace weft::bench {

/// Seconds of this thread's CPU time where it does all the work, so that others of the machine count less;
/// else of the wall's.
inline double seconds_now(int threads) {
    timespec now{};
    clock_gettime(threads == 1 ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The time of one run.
template <class Run>
double seconds_of(int threads, const Run& run) {
    const double begin = seconds_now(threads);
    run();
    return seconds_now(threads) - begin;
}

}  // namespace weft::bench
