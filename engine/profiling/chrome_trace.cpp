#include "engine/profiling/chrome_trace.h"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <map>
#include <string>

#include "engine/memory/without_exceptions.h"
#include "engine/platform.h"

namespace weft {

namespace {

// JSON is written as text, because a JSON library needs memory to clean up, and memory may have run out.
// Names are Weft's own, and hold nothing that JSON would have to escape.
void write_name(std::ostream& out, const char* kind, std::uint32_t thread, const std::string& name) {
    out << R"({"name":")" << kind << R"(","ph":"M","pid":1,"tid":)" << thread << R"(,"args":{"name":")"
        << name << R"("}})";
}

double microseconds(std::chrono::steady_clock::duration time) {
    return std::chrono::duration<double, std::micro>(time).count();
}

void write_event(std::ostream& out, const TraceEvent& event, std::chrono::steady_clock::time_point origin) {
    out << R"({"name":")" << event.name << R"(","ph":"X","pid":1,"tid":)" << event.thread << R"(,"ts":)"
        << microseconds(event.begin - origin) << R"(,"dur":)" << microseconds(event.end - event.begin);
    if (event.blocks > 0) out << R"(,"args":{"blocks":)" << event.blocks << '}';
    out << '}';
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
#ifdef WEFT_WITHOUT_FILES
    (void)write_event, (void)names_of_threads, (void)write_name, (void)events, (void)driver;
    return Error{ErrorCode::unsupported,
                 "the trace " + file.string() + " cannot be written: there are no files here"};
#else
    const auto first = std::ranges::min_element(events, {}, &TraceEvent::begin);
    const std::map<std::uint32_t, std::string> names = names_of_threads(events, driver);
    std::ofstream out(file);
    ignoring<std::ios_base::failure>([&] {
        if constexpr (has_exceptions)
            out.exceptions(std::ios_base::badbit);  // otherwise a stream hides that memory ran out
        out << std::fixed << std::setprecision(3) << "{\"displayTimeUnit\":\"ms\",\"traceEvents\":[\n";
        write_name(out, "process_name", 0, "weft");
        for (const auto& [thread, name] : names) {
            out << ",\n";
            write_name(out, "thread_name", thread, name);
        }
        for (const TraceEvent& event : events) {
            out << ",\n";
            write_event(out, event, first->begin);
        }
        out << "\n]}\n";
        out.close();
    });
    if (!out) return Error{ErrorCode::file_not_found, "the trace " + file.string() + " cannot be written"};
    return {};
#endif
}

}  // namespace weft
