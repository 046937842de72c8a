#include "engine/threads/parallel_blocks.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstring>
#include <functional>
#include <random>
#include <thread>
#include <vector>

#include "engine/platform.h"

#ifndef WEFT_STD_THREADS
#include <tbb/global_control.h>
#endif

namespace weft {
namespace {

#ifdef WEFT_WITHOUT_THREADS
void run_backwards(void*, std::uint32_t count, Executor::Body body, void* context) {
    for (std::uint32_t i = count; i-- > 0;) body(context, i);
}
#else
// A host that starts fresh threads for every step and hands the blocks out from the last to the first.
void run_backwards(void*, std::uint32_t count, Executor::Body body, void* context) {
    std::atomic<std::uint32_t> left = count;
    const auto work = [&] {
        for (std::uint32_t i; (i = left.load()) > 0;)
            if (left.compare_exchange_weak(i, i - 1)) body(context, i - 1);
    };
    std::thread first(work), second(work);
    first.join();
    second.join();
}
#endif

struct Case {
    const char* name;
    int threads;  // 0: the host's executor
};

void PrintTo(const Case& c, std::ostream* out) {
    *out << c.name;
}

class ParallelBlocks : public testing::TestWithParam<Case> {
  protected:
    Parallel make() {
        if (GetParam().threads > 0) return Parallel(GetParam().threads);
        return Parallel(Executor{.run = run_backwards, .width = 2});
    }

  private:
#ifndef WEFT_STD_THREADS
    // Without it oneTBB starts no more threads than there are cores, and the wide arenas would be tried in
    // name only.
    tbb::global_control many_threads_{tbb::global_control::max_allowed_parallelism, 8};
#endif
};

INSTANTIATE_TEST_SUITE_P(Widths, ParallelBlocks,
                         testing::Values(Case{"One", 1}, Case{"Two", 2}, Case{"Three", 3}, Case{"Eight", 8},
                                         Case{"Host", 0}),
                         [](const auto& info) { return info.param.name; });

TEST_P(ParallelBlocks, CutsTheRangeIntoBlocksOfOneSize) {
    Parallel parallel = make();
    for (const std::uint32_t n : {0u, 1u, 255u, 256u, 257u, 5000u}) {
        std::vector<BlockRange> ranges(block_count(n));
        parallel.lend(
            [&] { parallel.ranges(n, [&](const BlockRange& range) { ranges[range.block] = range; }); });
        std::uint32_t end = 0;
        for (const BlockRange& range : ranges) {
            EXPECT_EQ(range.begin, end);
            end = range.end;
            EXPECT_TRUE(range.end - range.begin == block_size || range.end == n);
        }
        EXPECT_EQ(end, n);
    }
}

TEST_P(ParallelBlocks, WritesTheBytesOfTheSerialLoop) {
    Parallel parallel = make();
    constexpr std::uint32_t n = 100'000;
    const auto value = [](std::uint32_t i) {
        return std::sin(static_cast<float>(i)) / static_cast<float>(i + 1);
    };
    std::vector<float> expected(n), actual(n);
    for (std::uint32_t i = 0; i < n; ++i) expected[i] = value(i);
    parallel.lend([&] {
        parallel.ranges(n, [&](const BlockRange& range) {
            for (std::uint32_t i = range.begin; i < range.end; ++i) actual[i] = value(i);
        });
    });
    EXPECT_EQ(std::memcmp(actual.data(), expected.data(), n * sizeof(float)), 0);
}

// Magnitudes from 1e-10 to 1e10 with both signs: any other order of additions gives other bits.
std::vector<float> numbers_whose_sum_depends_on_the_order(std::uint32_t n) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> exponent(-10, 10), mantissa(-1, 1);
    std::vector<float> numbers(n);
    for (float& x : numbers) x = mantissa(random) * std::pow(10.0f, exponent(random));
    return numbers;
}

float sum(std::span<const float> numbers) {
    float total = 0;
    for (const float x : numbers) total += x;
    return total;
}

TEST_P(ParallelBlocks, ReducesInBlockOrder) {
    const auto numbers = numbers_whose_sum_depends_on_the_order(20'000);
    const auto n = static_cast<std::uint32_t>(numbers.size());
    std::vector<float> partials;
    for (std::uint32_t begin = 0; begin < n; begin += block_size)
        partials.push_back(sum(std::span(numbers).subspan(begin, std::min(block_size, n - begin))));
    const float expected = sum(partials);
    const std::vector<float> reversed(partials.rbegin(), partials.rend());
    ASSERT_NE(expected, sum(reversed)) << "the numbers do not tell one order from another";

    Parallel parallel = make();
    for (int repeat = 0; repeat < 20; ++repeat) {
        std::vector<float> scratch(block_count(n));
        float actual = 0;
        parallel.lend([&] {
            actual = parallel.reduce(
                n, std::span(scratch), 0.0f,
                [&](const BlockRange& r) {
                    return sum(std::span(numbers).subspan(r.begin, r.end - r.begin));
                },
                std::plus<float>());
        });
        EXPECT_EQ(actual, expected);
    }
}

TEST_P(ParallelBlocks, MayBeUsedFromWithinABlock) {
    Parallel parallel = make();
    std::vector<std::atomic<int>> visits(16 * 16);
    parallel.lend([&] {
        parallel.blocks(16, [&](std::uint32_t outer) {
            parallel.blocks(16, [&](std::uint32_t inner) { ++visits[outer * 16 + inner]; });
        });
    });
    for (const auto& count : visits) EXPECT_EQ(count, 1);
}

#ifndef WEFT_WITHOUT_THREADS
// oneTBB warns on standard error where more threads are asked for than it starts.
TEST(ParallelArenas, OfMoreThreadsThanThereAreCoresAreMadeInSilence) {
    testing::internal::CaptureStderr();
    std::atomic<int> visits = 0;
    Parallel parallel(1);
    for (int repeat = 0; repeat < 20; ++repeat) {
        for (const int threads : {2, 3, 8, 256}) {
            parallel = Parallel(threads);
            parallel.blocks(50, [&](std::uint32_t) { ++visits; });
        }
    }
    EXPECT_EQ(visits, 20 * 4 * 50);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ParallelArenas, WorkSideBySide) {
    std::atomic<int> visits = 0;
    const auto use_own_arena = [&] {
        Parallel parallel(2);
        for (int repeat = 0; repeat < 100; ++repeat) parallel.blocks(10, [&](std::uint32_t) { ++visits; });
    };
    std::thread first(use_own_arena), second(use_own_arena);
    first.join();
    second.join();
    EXPECT_EQ(visits, 2000);
}
#endif

}  // namespace
}  // namespace weft
