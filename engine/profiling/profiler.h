#pragma once
// Times the stages of a step. Stages are named once; timing one costs two clock reads.
//
// Times are whole nanoseconds, so their sums do not depend on the order in which threads add them.

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <span>

#include "engine/profiling/trace_log.h"
#include "engine/profiling/tracy_zones.h"
#include "weft/error.h"
#include "weft/profile.h"

namespace weft {

/// A stage and its place in the tree: see StageTime.
struct StageName {
    const char* name = "";  ///< a string literal
    int depth = 1;
};

/// Stages may be timed on any thread, without locks; all else is called from one thread, outside of any
/// stage. Does not allocate after construction, save for start_trace().
class Profiler {
  public:
    static constexpr std::uint32_t window = 256;  ///< steps that the rolling percentiles cover

    /// `names`: in the order in which the stages run, each before its parts. At most 32.
    explicit Profiler(std::span<const StageName> names);

    void begin_step() noexcept;
    void end_step() noexcept;

    /// Adds the time from construction to destruction to a stage of the current step. A stage may run several
    /// times in a step, also at the same time (once per substep, once per cloth); its time is the sum.
    class Scope {
      public:
        Scope(Profiler& profiler, std::uint32_t stage) noexcept;
        ~Scope();
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

      private:
        Profiler& profiler_;
        std::uint32_t stage_;
        NamedActivity activity_;
        [[no_unique_address]] TracyZone zone_;
        std::chrono::steady_clock::time_point start_;
    };
    [[nodiscard]] Scope time(std::uint32_t stage) noexcept { return {*this, stage}; }

    /// The stages' last times and rolling percentiles, then one row named "step" for the whole.
    /// Valid until the next call; percentiles are computed by this call, not by the step.
    [[nodiscard]] std::span<const StageTime> stages() const;
    /// Milliseconds of one stage in the last step.
    [[nodiscard]] float last_ms(std::uint32_t stage) const noexcept { return rows_[stage].last; }
    /// Milliseconds of the whole last step.
    [[nodiscard]] float last_step_ms() const noexcept { return rows_[stage_count_].last; }

    /// Keeps every scope and the blocks of parallel loops from here on, up to `max_events`, for write_trace.
    /// Errors: those of TraceLog::start.
    Result<void> start_trace(std::size_t max_events);
    /// The log of loops that run in this profiler's stages.
    [[nodiscard]] TraceLog& trace() noexcept { return trace_; }
    /// Writes the kept scopes in Chrome's trace event format, which Perfetto and chrome://tracing open.
    /// Error: the file cannot be written, or start_trace was not called.
    [[nodiscard]] Result<void> write_trace(const std::filesystem::path& file) const;

  private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::uint32_t max_stages = 32;

    // One stage, or the whole step.
    struct Row {
        StageName name;
        std::atomic<std::int64_t> current = 0;  // so far in the present step [ns]
        float last = 0;                         // in the last whole step [ms]
        std::array<float, window> history{};    // ring: step s stands at s % window
    };

    void add(Row& row, Clock::time_point begin, Clock::time_point end) noexcept;
    [[nodiscard]] StageTime summary(const Row& row) const;

    std::uint32_t stage_count_;
    std::array<Row, max_stages + 1> rows_;  // the stages, then the step
    std::uint64_t steps_ = 0;
    Clock::time_point step_begin_;
    mutable std::array<StageTime, max_stages + 1> summaries_;  // result of stages()
    TraceLog trace_;
};

}  // namespace weft
