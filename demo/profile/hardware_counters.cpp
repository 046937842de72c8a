#include "demo/profile/hardware_counters.h"

#ifdef __linux__
#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace weft::demo {

#ifdef __linux__

namespace {

int open_counter(std::uint64_t event) {
    perf_event_attr attributes{};
    attributes.type = PERF_TYPE_HARDWARE;
    attributes.size = sizeof attributes;
    attributes.config = event;
    attributes.inherit = 1;  // counts threads that this one starts, too
    attributes.exclude_kernel = 1;
    attributes.exclude_hv = 1;
    return static_cast<int>(syscall(SYS_perf_event_open, &attributes, 0, -1, -1, 0));
}

}  // namespace

HardwareCounters::HardwareCounters()
    : files_{open_counter(PERF_COUNT_HW_CPU_CYCLES), open_counter(PERF_COUNT_HW_INSTRUCTIONS),
             open_counter(PERF_COUNT_HW_CACHE_MISSES)} {}

HardwareCounters::~HardwareCounters() {
    for (const int file : files_)
        if (file >= 0) close(file);
}

std::optional<HardwareCounters::Counts> HardwareCounters::read() const {
    std::array<std::uint64_t, 3> values{};
    for (std::size_t i = 0; i < files_.size(); ++i) {
        if (files_[i] < 0 || ::read(files_[i], &values[i], sizeof values[i]) != sizeof values[i]) return {};
    }
    return Counts{values[0], values[1], values[2]};
}

#else

HardwareCounters::HardwareCounters() : files_{} {}
HardwareCounters::~HardwareCounters() = default;
std::optional<HardwareCounters::Counts> HardwareCounters::read() const {
    return {};
}

#endif

}  // namespace weft::demo
