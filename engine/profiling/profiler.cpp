#include "engine/profiling/profiler.h"

#include <algorithm>
#include <cmath>

#include "engine/memory/hooks.h"
#include "engine/profiling/chrome_trace.h"

namespace weft {

namespace {

// Nearest rank: the smallest of the sorted values that at least the fraction q of them do not exceed.
float percentile(std::span<const float> sorted, double q) {
    const double rank = std::ceil(q * static_cast<double>(sorted.size()));
    return sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

}  // namespace

Profiler::Profiler(std::span<const StageName> names)
    : stage_count_(static_cast<std::uint32_t>(names.size())) {
    WEFT_ASSERT(names.size() <= max_stages);
    for (std::uint32_t stage = 0; stage < stage_count_; ++stage) rows_[stage].name = names[stage];
    rows_[stage_count_].name = {"step", 0};
}

void Profiler::begin_step() noexcept {
    for (Row& row : rows_) row.current = 0;
    tracy_begin_step();
    begin_zone(rows_[stage_count_].name.name);
    step_begin_ = Clock::now();
}

void Profiler::end_step() noexcept {
    add(rows_[stage_count_], step_begin_, Clock::now());
    end_zone(rows_[stage_count_].name.name);
    tracy_end_step();
    for (Row& row : rows_)
        row.last = row.history[steps_ % window] = 1e-6f * static_cast<float>(row.current.load());
    ++steps_;
}

Profiler::Scope::Scope(Profiler& profiler, std::uint32_t stage) noexcept
    : profiler_(profiler),
      stage_(stage),
      activity_(profiler.rows_[stage].name.name),
      zone_(profiler.rows_[stage].name.name),
      start_(Clock::now()) {
    begin_zone(profiler.rows_[stage].name.name);
}

Profiler::Scope::~Scope() {
    profiler_.add(profiler_.rows_[stage_], start_, Clock::now());
    end_zone(profiler_.rows_[stage_].name.name);
}

void Profiler::add(Row& row, Clock::time_point begin, Clock::time_point end) noexcept {
    row.current.fetch_add(std::chrono::nanoseconds(end - begin).count(), std::memory_order_relaxed);
    trace_.add(row.name.name, begin, end);
}

std::span<const StageTime> Profiler::stages() const {
    std::ranges::transform(std::span(rows_).first(stage_count_ + 1), summaries_.begin(),
                           [this](const Row& row) { return summary(row); });
    return std::span(summaries_).first(stage_count_ + 1);
}

StageTime Profiler::summary(const Row& row) const {
    StageTime time;
    time.name = row.name.name;
    time.depth = row.name.depth;
    time.samples = static_cast<std::uint32_t>(std::min<std::uint64_t>(steps_, window));
    if (time.samples == 0) return time;

    std::array<float, window> copy = row.history;
    const std::span<float> sorted = std::span(copy).first(time.samples);
    std::ranges::sort(sorted);
    time.last = row.last;
    time.p50 = percentile(sorted, 0.50);
    time.p95 = percentile(sorted, 0.95);
    time.p99 = percentile(sorted, 0.99);
    time.max = sorted.back();
    return time;
}

Result<void> Profiler::start_trace(std::size_t max_events) {
    return trace_.start(max_events);
}

Result<void> Profiler::write_trace(const std::filesystem::path& file) const {
    if (!trace_.is_on())
        return Error{ErrorCode::invalid_argument,
                     "no trace was kept; call start_trace before the steps to be traced"};
    return write_chrome_trace(file, trace_.events(), rows_[stage_count_].name.name);
}

}  // namespace weft
