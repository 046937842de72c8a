#include "engine/threads/loop_team.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

namespace weft {
namespace {

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
