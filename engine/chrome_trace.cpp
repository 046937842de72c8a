#include "engine/chrome_trace.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

namespace weft {

namespace {

using nlohmann::json;

json name_event(const char* kind, const char* name) {
    return {{"name", kind}, {"ph", "M"}, {"pid", 1}, {"tid", 1}, {"args", {{"name", name}}}};
}

double microseconds(std::chrono::steady_clock::duration time) {
    return std::chrono::duration<double, std::micro>(time).count();
}

json complete_event(const TraceEvent& event, std::chrono::steady_clock::time_point origin) {
    return {{"name", event.name},
            {"ph", "X"},
            {"pid", 1},
            {"tid", 1},
            {"ts", microseconds(event.begin - origin)},
            {"dur", microseconds(event.end - event.begin)}};
}

}  // namespace

Result<void> write_chrome_trace(const std::filesystem::path& file, std::span<const TraceEvent> events) {
    const auto first = std::ranges::min_element(events, {}, &TraceEvent::begin);
    std::ofstream out(file);
    // One event at a time: a million of them as one JSON tree would take a thousand times the memory of the
    // timings.
    out << "{\"displayTimeUnit\":\"ms\",\"traceEvents\":[\n" << name_event("process_name", "weft");
    out << ",\n" << name_event("thread_name", "World::step");
    for (const TraceEvent& event : events) out << ",\n" << complete_event(event, first->begin);
    out << "\n]}\n";
    out.close();
    if (!out) return Error{ErrorCode::file_not_found, "the trace " + file.string() + " cannot be written"};
    return {};
}

}  // namespace weft
