// A host's threads, lent once for a step of many loops.

#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <cstring>
#include <functional>
#include <memory>
#include <mutex>
#include <numeric>
#include <set>
#include <thread>
#include <vector>

#include "engine/threads/loop_team.h"
#include "engine/threads/parallel_blocks.h"
#include "tests/embedding/naive_pool.h"

namespace weft {

namespace {

using test::NaivePool;

template <bool backwards>
void run_serially(void* user, std::uint32_t count, Executor::Body body, void* context) {
    ++*static_cast<int*>(user);
    for (std::uint32_t i = 0; i < count; ++i) body(context, backwards ? count - 1 - i : i);
}

// Blocks are begun from the last to the first, each on a thread of its own, which ends before the next
// begins.
void run_on_threads_in_turn(void* user, std::uint32_t count, Executor::Body body, void* context) {
    ++*static_cast<int*>(user);
    for (std::uint32_t i = count; i-- > 0;) std::thread([&] { body(context, i); }).join();
}

// Every loop reads what the one before wrote, from the other end, and adds up in block order: a block that is
// lost, repeated or late shows in the sum.
class ManyLoops {
  public:
    ManyLoops() : values_(20 * block_size + 7), partials_(block_count(size())) {
        std::iota(values_.begin(), values_.end(), 1.0f);
    }
    void run(Parallel& parallel, int loops) {
        for (int loop = 0; loop < loops; ++loop) {
            sum_ = parallel.reduce(
                size(), std::span(partials_), 0.0f,
                [&](const BlockRange& range) {
                    const auto part = std::span(values_).subspan(range.begin, range.end - range.begin);
                    return std::reduce(part.begin(), part.end(), 0.0f);
                },
                std::plus<>());
            std::vector<float> next(values_.size());
            parallel.ranges(size(), [&](const BlockRange& range) {
                for (std::uint32_t i = range.begin; i < range.end; ++i)
                    next[i] = 0.7f * values_[size() - 1 - i] + sum_ / static_cast<float>(i + size());
            });
            values_ = std::move(next);
        }
    }
    friend bool operator==(const ManyLoops& a, const ManyLoops& b) {
        return a.sum_ == b.sum_ &&
               std::memcmp(a.values_.data(), b.values_.data(), a.values_.size() * sizeof(float)) == 0;
    }

  private:
    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(values_.size()); }

    std::vector<float> values_, partials_;
    float sum_ = 0;
};

ManyLoops serial_result(int loops) {
    ManyLoops result;
    Parallel serial(1);
    result.run(serial, loops);
    return result;
}

constexpr int loops_of_a_step = 70;

TEST(HostTeam, GivesTheSameBytesOnAPoolOfAnyThreads) {
    const ManyLoops expected = serial_result(10 * loops_of_a_step);
    for (const int threads : {1, 2, 3, 8}) {
        for (const int width : {2, 3, 8}) {  // narrower than the pool, and wider
            NaivePool pool(threads);
            Parallel parallel(pool.executor(width));
            ManyLoops actual;
            for (int step = 0; step < 10; ++step)
                parallel.lend([&] { actual.run(parallel, loops_of_a_step); });
            EXPECT_TRUE(actual == expected) << threads << " threads, width " << width;
            EXPECT_EQ(pool.calls(), 10) << "once a step";
        }
    }
}

TEST(HostTeam, EndsWhereBlocksRunOneAfterTheOther) {
    const ManyLoops expected = serial_result(3 * loops_of_a_step);
    for (const auto run : {run_serially<false>, run_serially<true>, run_on_threads_in_turn}) {
        for (const int width : {2, 5, 256}) {
            int calls = 0;
            Parallel parallel(Executor{.run = run, .user = &calls, .width = width});
            ManyLoops actual;
            for (int step = 0; step < 3; ++step)
                parallel.lend([&] { actual.run(parallel, loops_of_a_step); });
            EXPECT_TRUE(actual == expected) << width;
            EXPECT_EQ(calls, 3);
        }
    }
}

// Each block waits for the other two: on fewer than three threads this would not end.
TEST(HostTeam, HasAllOfItsThreadsInALoop) {
    NaivePool pool(3);
    Parallel parallel(pool.executor(3));
    for (int step = 0; step < 20; ++step) {
        std::atomic<int> here = 0;
        parallel.lend([&] {
            parallel.blocks(3, [&](std::uint32_t) {
                ++here;
                while (here < 3) std::this_thread::yield();
            });
        });
        EXPECT_EQ(here, 3);
    }
}

TEST(HostTeam, HelpersStayThroughAStepThatIsLongWithoutALoop) {
    NaivePool pool(2);
    Parallel parallel(pool.executor(2));
    std::atomic<int> here = 0;
    parallel.lend([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        parallel.blocks(2, [&](std::uint32_t) {
            ++here;
            while (here < 2) std::this_thread::yield();
        });
    });
    EXPECT_EQ(here, 2);
}

TEST(HostTeam, RunsALoopWithinABodyOnItsThread) {
    NaivePool pool(3);
    Parallel parallel(pool.executor(3));
    std::vector<std::atomic<int>> visits(16 * 16);
    std::atomic<int> strangers = 0;
    parallel.lend([&] {
        parallel.blocks(16, [&](std::uint32_t outer) {
            const std::thread::id own = std::this_thread::get_id();
            parallel.blocks(16, [&](std::uint32_t inner) {
                ++visits[outer * 16 + inner];
                strangers += std::this_thread::get_id() != own;
            });
        });
    });
    for (const auto& count : visits) EXPECT_EQ(count, 1);
    EXPECT_EQ(strangers, 0);
}

TEST(HostTeam, IsLentOnceForStepsWithinAStep) {
    NaivePool pool(2);
    Parallel parallel(pool.executor(2));
    std::atomic<int> visits = 0;
    parallel.lend([&] {
        parallel.lend([&] { parallel.blocks(10, [&](std::uint32_t) { ++visits; }); });
        parallel.blocks(10, [&](std::uint32_t) { ++visits; });
    });
    EXPECT_EQ(visits, 20);
    EXPECT_EQ(pool.calls(), 1);
}

TEST(HostTeam, IsNotCalledOutsideOfSteps) {
    NaivePool pool(2);
    Parallel parallel(pool.executor(2));
    const std::thread::id own = std::this_thread::get_id();
    int visits = 0;
    const auto visit = [&](std::uint32_t) {
        EXPECT_EQ(std::this_thread::get_id(), own);
        ++visits;
    };
    parallel.blocks(10, visit);
    parallel.lend([] {});
    parallel.blocks(10, visit);
    EXPECT_EQ(visits, 20);
    EXPECT_EQ(pool.calls(), 1);
}

TEST(HostTeam, TakesAStepOnTheCallersThreadAtWidthOne) {
    NaivePool pool(1);
    Parallel parallel(pool.executor(1));
    std::thread::id thread;
    parallel.lend([&] { thread = std::this_thread::get_id(); });
    EXPECT_EQ(thread, std::this_thread::get_id());
    EXPECT_EQ(pool.calls(), 0);
}

// Steps of two, with blocks that are over at once: helpers are late for most loops, and for whole steps.
TEST(HostTeam, TakesEachBlockOfManyShortStepsOnce) {
    for (const int width : {2, 3, 8}) {
        NaivePool pool(width);
        Parallel parallel(pool.executor(width));
        std::vector<std::uint32_t> counts(40, 0), expected(40, 0);
        for (std::uint32_t step = 0; step < 1'000; ++step) {
            parallel.lend([&] {
                for (std::uint32_t loop = 0; loop < 2; ++loop)
                    parallel.blocks((step + loop) * 7 % 41,
                                    [&](std::uint32_t block) { counts[block] += counts[block] % 3 + 1; });
            });
            for (std::uint32_t loop = 0; loop < 2; ++loop)
                for (std::uint32_t block = 0; block < (step + loop) * 7 % 41; ++block)
                    expected[block] += expected[block] % 3 + 1;
        }
        EXPECT_EQ(counts, expected) << width;
    }
}

TEST(HostTeam, OfTwoWorldsDoNotDisturbEachOther) {
    const auto run = [](void*, std::uint32_t count, Executor::Body body, void* context) {
        std::vector<std::jthread> threads;
        for (std::uint32_t i = 0; i < count; ++i) threads.emplace_back([=] { body(context, i); });
    };
    const ManyLoops expected = serial_result(5 * loops_of_a_step);
    std::vector<ManyLoops> results(2);
    {
        std::vector<std::jthread> worlds;
        for (ManyLoops& result : results) {
            worlds.emplace_back([&result, run] {
                Parallel parallel(Executor{.run = run, .width = 3});
                for (int step = 0; step < 5; ++step)
                    parallel.lend([&] { result.run(parallel, loops_of_a_step); });
            });
        }
    }
    for (const ManyLoops& result : results) EXPECT_TRUE(result == expected);
}

/// A team and its runner, whose helpers are fresh threads, or none.
class Loops {
  public:
    explicit Loops(std::uint32_t width, bool has_helpers = true)
        : team_(width), has_helpers_(has_helpers), threads_(width) {}
    ~Loops() {
        team_.close();
        for (std::thread& thread : threads_)
            if (thread.joinable()) thread.join();
    }

    template <class Body>
    void run(std::uint32_t block_count, const Body& body) {
        team_.run(
            block_count,
            [](void* context, std::uint32_t block) noexcept { (*static_cast<const Body*>(context))(block); },
            const_cast<Body*>(&body),
            [&](std::uint32_t place) {
                ++sent_;
                if (!has_helpers_) return true;
                if (threads_[place].joinable()) threads_[place].join();  // it has left
                threads_[place] = std::thread([this, place] { team_.help(place, patience); });
                return true;
            });
    }
    [[nodiscard]] int sent() const { return sent_; }

  private:
    static constexpr std::chrono::microseconds patience{200};

    LoopTeam team_;
    bool has_helpers_;
    std::vector<std::thread> threads_;  // by place
    int sent_ = 0;
};

TEST(LoopTeam, SpreadsTheBlocksOverItsThreads) {
    Loops loops(3);
    std::mutex mutex;
    std::condition_variable all_here;
    std::set<std::thread::id> threads;
    // Each block waits for the other two: on fewer than three threads this would not end.
    loops.run(3, [&](std::uint32_t) {
        std::unique_lock lock(mutex);
        threads.insert(std::this_thread::get_id());
        all_here.notify_all();
        all_here.wait(lock, [&] { return threads.size() == 3; });
    });
    EXPECT_EQ(threads.size(), 3u);
}

TEST(LoopTeam, RunnerDoesAllWhereHelpersNeverCome) {
    Loops loops(4, false);
    std::vector<int> visits(100, 0);
    for (int repeat = 0; repeat < 3; ++repeat) loops.run(100, [&](std::uint32_t block) { ++visits[block]; });
    EXPECT_EQ(visits, std::vector<int>(100, 3));
    EXPECT_EQ(loops.sent(), 3) << "each place is sent for once, and then waited for";
}

// Loops so short that helpers are late for most, of lengths that leave places without blocks; what one loop
// wrote the next reads.
TEST(LoopTeam, TakesEachBlockOfManyShortLoopsOnce) {
    for (const std::uint32_t width : {2u, 3u, 8u}) {
        Loops loops(width);
        std::vector<std::uint32_t> counts(40, 0), expected(40, 0);
        for (std::uint32_t loop = 0; loop < 20'000; ++loop) {
            const std::uint32_t length = loop * 7 % 41;
            loops.run(length, [&](std::uint32_t block) { counts[block] += counts[block] % 3 + 1; });
            for (std::uint32_t block = 0; block < length; ++block) expected[block] += expected[block] % 3 + 1;
        }
        EXPECT_EQ(counts, expected) << width;
    }
}

TEST(LoopTeam, HelpersThatLeftAreSentForAgain) {
    Loops loops(2);
    loops.run(2, [](std::uint32_t) {});
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (loops.sent() < 2 && std::chrono::steady_clock::now() < limit) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        loops.run(2, [](std::uint32_t) {});
    }
    EXPECT_EQ(loops.sent(), 2);
}

TEST(LoopTeam, SendsAgainForAHelperThatCouldNotBeHad) {
    LoopTeam team(2);
    int sent = 0, visits = 0;
    for (int loop = 0; loop < 3; ++loop) {
        team.run(
            5, [](void* count, std::uint32_t) noexcept { ++*static_cast<int*>(count); }, &visits,
            [&](std::uint32_t) {
                ++sent;
                return false;
            });
    }
    EXPECT_EQ(sent, 3);
    EXPECT_EQ(visits, 15);
}

}  // namespace

}  // namespace weft
