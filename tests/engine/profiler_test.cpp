#include "engine/profiling/profiler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "engine/platform.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {
namespace {

constexpr StageName two_stages[] = {{"forces"}, {"solve"}};
enum : std::uint32_t { forces, solve };

void spin(std::chrono::nanoseconds time) {
    const auto end = std::chrono::steady_clock::now() + time;
    while (std::chrono::steady_clock::now() < end) {
    }
}

void run_step(Profiler& profiler, std::chrono::nanoseconds time = {}) {
    profiler.begin_step();
    {
        const auto scope = profiler.time(forces);
        spin(time);
    }
    profiler.end_step();
}

TEST(Profiler, ListsTheStagesInOrderAndThenTheStep) {
    const Profiler profiler(two_stages);
    const auto stages = profiler.stages();
    ASSERT_EQ(stages.size(), 3u);
    EXPECT_STREQ(stages[0].name, "forces");
    EXPECT_STREQ(stages[1].name, "solve");
    EXPECT_STREQ(stages[2].name, "step");
    EXPECT_EQ(stages[0].depth, 1);
    EXPECT_EQ(stages[2].depth, 0);
    for (const StageTime& stage : stages)
        EXPECT_TRUE(stage.samples == 0 && stage.last == 0 && stage.max == 0);
}

TEST(Profiler, AddsUpTheRunsOfAStageAndStaysBelowTheStep) {
    using namespace std::chrono_literals;
    Profiler profiler(two_stages);
    profiler.begin_step();
    for (int run = 0; run < 3; ++run) {
        const auto scope = profiler.time(forces);
        spin(100us);
    }
    profiler.end_step();
    EXPECT_GE(profiler.last_ms(forces), 0.3f);
    EXPECT_EQ(profiler.last_ms(solve), 0);
    EXPECT_GE(profiler.last_step_ms(), profiler.last_ms(forces) * 0.999f);
}

TEST(Profiler, PutsPartsBelowTheirStage) {
    constexpr StageName tree[] = {{"solve", 1}, {"cycles", 2}, {"guard", 1}};
    Profiler profiler(tree);
    profiler.begin_step();
    {
        const auto whole = profiler.time(0);
        spin(std::chrono::microseconds(50));
        const auto part = profiler.time(1);
        spin(std::chrono::microseconds(50));
    }
    profiler.end_step();
    const auto stages = profiler.stages();
    EXPECT_EQ(stages[1].depth, 2);
    EXPECT_EQ(stages[2].depth, 1);
    EXPECT_GE(profiler.last_ms(1), 0.05f);
    EXPECT_GE(profiler.last_ms(0), profiler.last_ms(1) + 0.049f);
}

#ifndef WEFT_WITHOUT_THREADS
TEST(Profiler, AddsUpWhatSeveralThreadsDoAtOnce) {
    constexpr int threads = 4, runs = 500;
    Profiler profiler(two_stages);
    ASSERT_TRUE(profiler.start_trace(threads * runs).ok());
    profiler.begin_step();
    {
        std::vector<std::jthread> workers;
        for (int i = 0; i < threads; ++i) {
            workers.emplace_back([&] {
                for (int run = 0; run < runs; ++run) const auto scope = profiler.time(forces);
            });
        }
    }
    profiler.end_step();
    const std::span<const TraceEvent> events = profiler.trace().events();
    ASSERT_EQ(events.size(), static_cast<std::size_t>(threads * runs));
    std::int64_t nanoseconds = 0;
    for (const TraceEvent& event : events)
        nanoseconds += std::chrono::nanoseconds(event.end - event.begin).count();
    EXPECT_EQ(profiler.last_ms(forces), 1e-6f * static_cast<float>(nanoseconds));
}
#endif

TEST(Profiler, KeepsTheLastStepUntilTheNextIsWhole) {
    using namespace std::chrono_literals;
    Profiler profiler(two_stages);
    run_step(profiler, 50us);
    const float last = profiler.last_ms(forces);
    profiler.begin_step();
    EXPECT_EQ(profiler.last_ms(forces), last);
    profiler.end_step();
    EXPECT_EQ(profiler.last_ms(forces), 0);
}

// The percentiles by their definition: nearest rank in the sorted times of the last `samples` steps.
void expect_percentiles(const StageTime& stage, std::span<const float> times) {
    std::vector<float> sorted(times.begin(), times.end());
    std::ranges::sort(sorted);
    const auto rank = [&](std::size_t percent) { return sorted[(percent * sorted.size() + 99) / 100 - 1]; };
    EXPECT_EQ(stage.samples, sorted.size());
    EXPECT_EQ(stage.last, times.back());
    EXPECT_EQ(stage.p50, rank(50));
    EXPECT_EQ(stage.p95, rank(95));
    EXPECT_EQ(stage.p99, rank(99));
    EXPECT_EQ(stage.max, sorted.back());
}

TEST(Profiler, RollsItsPercentilesOverTheWindow) {
    Profiler profiler(two_stages);
    std::vector<float> stage_times, step_times;
    for (std::uint32_t step = 1; step <= 3 * Profiler::window; ++step) {
        run_step(profiler, std::chrono::nanoseconds(step * 7919 % 20000));
        stage_times.push_back(profiler.last_ms(forces));
        step_times.push_back(profiler.last_step_ms());
        if (step > 3 && step % 100 != 0) continue;
        const std::size_t kept = std::min(step, Profiler::window);
        const auto stages = profiler.stages();
        expect_percentiles(stages[forces], std::span(stage_times).last(kept));
        expect_percentiles(stages[2], std::span(step_times).last(kept));
    }
}

#ifndef WEFT_WITHOUT_FILES
class Trace : public testing::Test {
  protected:
    ~Trace() override { std::filesystem::remove(file_); }

    nlohmann::json written(const Profiler& profiler) {
        const auto result = profiler.write_trace(file_);
        EXPECT_TRUE(result.ok()) << result.error().message;
        return nlohmann::json::parse(std::ifstream(file_))["traceEvents"];
    }

    static std::vector<nlohmann::json> complete_events(const nlohmann::json& events) {
        std::vector<nlohmann::json> complete;
        std::ranges::copy_if(events, std::back_inserter(complete),
                             [](const auto& e) { return e["ph"] == "X"; });
        return complete;
    }

    std::filesystem::path file_ =
        std::filesystem::path(testing::TempDir()) /
        (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".json");
};

TEST_F(Trace, HoldsEveryScopeInsideItsStep) {
    Profiler profiler(two_stages);
    ASSERT_TRUE(profiler.start_trace(100).ok());
    for (int step = 0; step < 5; ++step) {
        profiler.begin_step();
        { const auto scope = profiler.time(forces); }
        { const auto scope = profiler.time(solve); }
        profiler.end_step();
    }
    const auto events = complete_events(written(profiler));
    ASSERT_EQ(events.size(), 15u);
    constexpr double rounding = 1e-3;  // [us]
    for (int step = 0; step < 5; ++step) {
        const nlohmann::json* const row =
            &events[static_cast<std::size_t>(step) * 3];  // a scope is kept when it ends
        EXPECT_EQ(row[0]["name"], "forces");
        EXPECT_EQ(row[1]["name"], "solve");
        EXPECT_EQ(row[2]["name"], "step");
        const auto begin = [](const nlohmann::json& e) { return e["ts"].get<double>(); };
        const auto end = [](const nlohmann::json& e) {
            return e["ts"].get<double>() + e["dur"].get<double>();
        };
        EXPECT_GE(begin(row[0]), begin(row[2]));
        EXPECT_GE(begin(row[1]), end(row[0]) - rounding);
        EXPECT_LE(end(row[1]), end(row[2]) + rounding);
    }
}

double begin_of(const nlohmann::json& event) {
    return event["ts"].get<double>();
}
double end_of(const nlohmann::json& event) {
    return begin_of(event) + event["dur"].get<double>();
}

// Perfetto stacks the events of a track: each must lie inside what is open when it begins, or after it.
void expect_nested(std::vector<nlohmann::json> track) {
    constexpr double rounding = 1e-3;  // [us]
    std::ranges::sort(track, [](const auto& a, const auto& b) {
        return std::pair(begin_of(a), -end_of(a)) < std::pair(begin_of(b), -end_of(b));
    });
    std::vector<double> open;
    for (const nlohmann::json& event : track) {
        while (!open.empty() && open.back() <= begin_of(event) + rounding) open.pop_back();
        const double enclosing = open.empty() ? end_of(event) : open.back();
        EXPECT_LE(end_of(event), enclosing + rounding) << event;
        open.push_back(end_of(event));
    }
}

TEST_F(Trace, HasATrackPerThreadWhoseEventsNest) {
    Profiler profiler(two_stages);
    Parallel parallel(3);
    parallel.trace_to(&profiler.trace());
    ASSERT_TRUE(profiler.start_trace(10'000).ok());
    const auto work = [](std::uint32_t) { spin(std::chrono::microseconds(5)); };
    for (int step = 0; step < 20; ++step) {
        profiler.begin_step();
        {
            const auto scope = profiler.time(forces);
            parallel.blocks(16, work);
        }
        parallel.blocks(6, [&](std::uint32_t) {
            const auto scope = profiler.time(solve);
            parallel.blocks(2, work);
        });
        profiler.end_step();
    }
    const auto events = written(profiler);
    std::map<int, std::vector<nlohmann::json>> tracks;
    for (const nlohmann::json& event : complete_events(events)) tracks[event["tid"]].push_back(event);
    for (const auto& [thread, track] : tracks) expect_nested(track);

    std::map<int, std::string> names;
    for (const nlohmann::json& event : events)
        if (event["name"] == "thread_name") names[event["tid"]] = event["args"]["name"];
    EXPECT_EQ(names.size(), tracks.size());
    EXPECT_EQ(std::ranges::count(names, "step", [](const auto& entry) { return entry.second; }), 1);

    std::uint32_t blocks = 0;  // of the loops in stage forces
    for (const nlohmann::json& event : complete_events(events))
        if (event["name"] == "forces" && event.contains("args"))
            blocks += event["args"]["blocks"].get<std::uint32_t>();
    EXPECT_EQ(blocks, 20u * 16u);
}

TEST_F(Trace, HoldsNoBlocksOfALoopThatIsNotTracedAnyMore) {
    Profiler profiler(two_stages);
    Parallel parallel(2);
    parallel.trace_to(&profiler.trace());
    parallel.trace_to(nullptr);
    ASSERT_TRUE(profiler.start_trace(100).ok());
    parallel.blocks(16, [](std::uint32_t) {});
    EXPECT_EQ(profiler.trace().events().size(), 0u);
}

TEST_F(Trace, NamesItsProcessAndThread) {
    Profiler profiler(two_stages);
    ASSERT_TRUE(profiler.start_trace(2).ok());
    run_step(profiler);
    const auto events = written(profiler);
    ASSERT_EQ(events.size(), 4u);
    EXPECT_EQ(events[0]["name"], "process_name");
    EXPECT_EQ(events[0]["args"]["name"], "weft");
    EXPECT_EQ(events[1]["name"], "thread_name");
    EXPECT_EQ(events[1]["args"]["name"], "step");
}

TEST_F(Trace, StopsWhenItIsFull) {
    Profiler profiler(two_stages);
    ASSERT_TRUE(profiler.start_trace(7).ok());
    for (int step = 0; step < 10; ++step) run_step(profiler);
    EXPECT_EQ(complete_events(written(profiler)).size(), 7u);
}

TEST_F(Trace, NamesTheFileThatCannotBeWritten) {
    Profiler profiler(two_stages);
    ASSERT_TRUE(profiler.start_trace(1).ok());
    const auto result = profiler.write_trace("/no/such/folder/trace.json");
    ASSERT_FALSE(result.ok());
    EXPECT_NE(result.error().message.find("/no/such/folder/trace.json"), std::string::npos);
}
#endif

}  // namespace
}  // namespace weft
