#include "engine/profiling/trace_log.h"

#include <algorithm>
#include <string>
#include <utility>

#include "engine/memory/without_exceptions.h"

namespace weft {

namespace {

thread_local const char* activity = "loop";

}  // namespace

std::uint32_t thread_number() noexcept {
    static std::atomic<std::uint32_t> threads = 0;
    thread_local const std::uint32_t number = ++threads;
    return number;
}

Result<void> TraceLog::start(std::size_t max_events) {
    if (max_events < 1 || max_events > most_events)
        return Error{ErrorCode::invalid_argument, "max_events is " + std::to_string(max_events) +
                                                      "; it must be 1 to " + std::to_string(most_events)};
    if (!comes_through([&] { events_ = std::vector<TraceEvent>(max_events); }))
        return Error{ErrorCode::out_of_memory,
                     "no memory for " + std::to_string(max_events) + " events of a trace; ask for fewer"};
    appended_ = 0;
    return {};
}

TraceEvent* TraceLog::append(const TraceEvent& event) noexcept {
    if (appended_.load(std::memory_order_relaxed) >= events_.size()) return nullptr;
    const std::size_t at = appended_.fetch_add(1, std::memory_order_relaxed);
    if (at >= events_.size()) return nullptr;
    events_[at] = event;
    return &events_[at];
}

void TraceLog::add(const char* name, Time begin, Time end) noexcept {
    append({.name = name, .thread = thread_number(), .begin = begin, .end = end});
}

void TraceLog::add_block(std::uint64_t loop, const char* name, Time begin, Time end) noexcept {
    // Loop numbers are never used again, so an event of an earlier log is never touched.
    thread_local std::uint64_t last_loop = 0;
    thread_local TraceEvent* last_event = nullptr;
    if (last_loop != loop) {
        last_loop = loop;
        last_event =
            append({.name = name, .thread = thread_number(), .blocks = 1, .begin = begin, .end = end});
    } else if (last_event != nullptr) {
        last_event->end = end;
        ++last_event->blocks;
    }
}

std::uint64_t TraceLog::new_loop() noexcept {
    static std::atomic<std::uint64_t> loops = 0;
    return ++loops;
}

std::span<const TraceEvent> TraceLog::events() const noexcept {
    return std::span(events_).first(std::min(appended_.load(), events_.size()));
}

NamedActivity::NamedActivity(const char* name) noexcept : outer_(std::exchange(activity, name)) {}

NamedActivity::~NamedActivity() {
    activity = outer_;
}

const char* NamedActivity::current() noexcept {
    return activity;
}

}  // namespace weft
