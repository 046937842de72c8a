#pragma once
// Cycles, instructions and cache misses of this process, where the kernel lets it count them.

#include <array>
#include <cstdint>
#include <optional>

namespace weft::demo {

class HardwareCounters {
  public:
    struct Counts {
        std::uint64_t cycles = 0, instructions = 0, cache_misses = 0;
        friend Counts operator-(const Counts& a, const Counts& b) {
            return {a.cycles - b.cycles, a.instructions - b.instructions, a.cache_misses - b.cache_misses};
        }
        Counts& operator+=(const Counts& b) {
            cycles += b.cycles;
            instructions += b.instructions;
            cache_misses += b.cache_misses;
            return *this;
        }
    };

    /// Counts the calling thread and the threads that it starts later.
    HardwareCounters();
    ~HardwareCounters();
    HardwareCounters(const HardwareCounters&) = delete;
    HardwareCounters& operator=(const HardwareCounters&) = delete;

    /// Counts since construction, in user mode. Empty where the kernel or the machine offers no counters.
    [[nodiscard]] std::optional<Counts> read() const;

  private:
    std::array<int, 3> files_;
};

}  // namespace weft::demo
