#include "engine/thread_pool.h"

#include <gtest/gtest.h>

#include <mutex>
#include <set>

namespace weft {
namespace {

TEST(ThreadPool, SpreadsTheBlocksOverItsThreads) {
    struct Meeting {
        std::mutex mutex;
        std::condition_variable all_here;
        std::set<std::thread::id> threads;
    } meeting;
    ThreadPool pool(3);
    // Each block waits for the other two: on fewer than three threads this would not end.
    pool.run(
        3,
        [](void* context, std::uint32_t) noexcept {
            auto& [mutex, all_here, threads] = *static_cast<Meeting*>(context);
            std::unique_lock lock(mutex);
            threads.insert(std::this_thread::get_id());
            all_here.notify_all();
            all_here.wait(lock, [&threads = threads] { return threads.size() == 3; });
        },
        &meeting);
    EXPECT_EQ(meeting.threads.size(), 3u);
}

TEST(ThreadPool, RunsManyShortLoopsAndStops) {
    std::atomic<int> visits = 0;
    for (int repeat = 0; repeat < 20; ++repeat) {
        ThreadPool pool(4);
        for (int loop = 0; loop < 100; ++loop)
            pool.run(
                5, [](void* context, std::uint32_t) noexcept { ++*static_cast<std::atomic<int>*>(context); },
                &visits);
    }
    EXPECT_EQ(visits, 20 * 100 * 5);
}

}  // namespace
}  // namespace weft
