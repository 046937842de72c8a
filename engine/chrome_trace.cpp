#include "engine/chrome_trace.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace weft {

namespace {

using nlohmann::json;

json name_event(const char* kind, std::uint32_t thread, const std::string& name) {
    return {{"name", kind}, {"ph", "M"}, {"pid", 1}, {"tid", thread}, {"args", {{"name", name}}}};
}

double microseconds(std::chrono::steady_clock::duration time) {
    return std::chrono::duration<double, std::micro>(time).count();
}

json complete_event(const TraceEvent& event, std::chrono::steady_clock::time_point origin) {
    json written = {{"name", event.name},
                    {"ph", "X"},
                    {"pid", 1},
                    {"tid", event.thread},
                    {"ts", microseconds(event.begin - origin)},
                    {"dur", microseconds(event.end - event.begin)}};
    if (event.blocks > 0) written["args"] = {{"blocks", event.blocks}};
    return written;
}

std::map<std::uint32_t, std::string> names_of_threads(std::span<const TraceEvent> events,
                                                      std::string_view driver) {
    std::map<std::uint32_t, std::string> names;
    for (const TraceEvent& event : events) {
        if (driver == event.name)
            names[event.thread] = driver;
        else
            names.try_emplace(event.thread, "worker " + std::to_string(event.thread));
    }
    return names;
}

}  // namespace

Result<void> write_chrome_trace(const std::filesystem::path& file, std::span<const TraceEvent> events,
                                const char* driver) {
    const auto first = std::ranges::min_element(events, {}, &TraceEvent::begin);
    std::ofstream out(file);
    // One event at a time: a million of them as one JSON tree would take a thousand times the memory of the
    // timings.
    out << "{\"displayTimeUnit\":\"ms\",\"traceEvents\":[\n" << name_event("process_name", 0, "weft");
    for (const auto& [thread, name] : names_of_threads(events, driver))
        out << ",\n" << name_event("thread_name", thread, name);
    for (const TraceEvent& event : events) out << ",\n" << complete_event(event, first->begin);
    out << "\n]}\n";
    out.close();
    if (!out) return Error{ErrorCode::file_not_found, "the trace " + file.string() + " cannot be written"};
    return {};
}

}  // namespace weft
