// The calls that the Tracy profiler would receive. The library's profiler is compiled here once more, with
// WEFT_TRACY, against a stand-in for Tracy's header that writes down the calls.

#include <gtest/gtest.h>
#include <tracy/TracyC.h>

#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "engine/profiling/profiler.h"
#include "engine/threads/parallel_blocks.h"

namespace {

struct Recorder {
    std::mutex mutex;
    std::vector<std::string> names;                         // of source locations, and of zones: by number
    std::map<std::thread::id, std::vector<unsigned>> open;  // zones, innermost last
    std::vector<std::string> frames;                        // "+name" and "-name"
    int out_of_order = 0;                                   // zones that ended before one within them
    std::map<std::string, int> ended;
};

Recorder& recorder() {
    static Recorder instance;
    return instance;
}

}  // namespace

std::uint64_t ___tracy_alloc_srcloc_name(std::uint32_t /*line*/, const char* /*source*/,
                                         std::size_t /*source_size*/, const char* /*function*/,
                                         std::size_t /*function_size*/, const char* name,
                                         std::size_t name_size, std::uint32_t /*color*/) {
    const std::lock_guard lock(recorder().mutex);
    recorder().names.emplace_back(name, name_size);
    return recorder().names.size() - 1;
}

TracyCZoneCtx ___tracy_emit_zone_begin_alloc(std::uint64_t source_location, int /*active*/) {
    const std::lock_guard lock(recorder().mutex);
    const auto id = static_cast<unsigned>(source_location);
    recorder().open[std::this_thread::get_id()].push_back(id);
    return {id};
}

void ___tracy_emit_zone_end(TracyCZoneCtx zone) {
    const std::lock_guard lock(recorder().mutex);
    std::vector<unsigned>& open = recorder().open[std::this_thread::get_id()];
    if (open.empty() || open.back() != zone.id)
        ++recorder().out_of_order;
    else
        open.pop_back();
    ++recorder().ended[recorder().names[zone.id]];
}

void ___tracy_emit_frame_mark_start(const char* name) {
    recorder().frames.push_back(std::string("+") + name);
}

void ___tracy_emit_frame_mark_end(const char* name) {
    recorder().frames.push_back(std::string("-") + name);
}

namespace weft {
namespace {

TEST(Tracy, SeesStepsStagesAndTheirBlocksOnEachThread) {
    constexpr StageName stages[] = {{"forces"}, {"solve"}};
    Profiler profiler(stages);
    Parallel parallel(2);
    parallel.trace_to(&profiler.trace());  // a log that is not on

    constexpr std::uint32_t blocks = 5;
    for (int step = 0; step < 3; ++step) {
        profiler.begin_step();
        for (const std::uint32_t stage : {0u, 1u}) {
            const auto scope = profiler.time(stage);
            parallel.ranges(blocks * block_size, [](const BlockRange&) {});
        }
        profiler.end_step();
    }

    const std::map<std::string, int> expected = {{"forces", 3 * (1 + blocks)}, {"solve", 3 * (1 + blocks)}};
    EXPECT_EQ(recorder().ended, expected);
    EXPECT_EQ(recorder().out_of_order, 0);
    for (const auto& [thread, zones] : recorder().open) EXPECT_TRUE(zones.empty());
    const std::vector<std::string> frames = {"+cloth step", "-cloth step", "+cloth step",
                                             "-cloth step", "+cloth step", "-cloth step"};
    EXPECT_EQ(recorder().frames, frames);
}

}  // namespace
}  // namespace weft
