// World::step does not allocate once it is warm.

#include <gtest/gtest.h>

#include <new>
#include <tuple>

#include "tests/guarantees/allocation_count.h"
#include "tests/guarantees/scene_run.h"

namespace weft::demo {
namespace {

TEST(AllocationCount, SeesEveryFormOfNew) {
    constexpr std::align_val_t wide{64};
    const std::uint64_t before = allocation_count();
    ::operator delete(::operator new(1));
    ::operator delete[](::operator new[](1));
    ::operator delete(::operator new(1, wide), wide);
    ::operator delete[](::operator new[](1, wide), wide);
    ::operator delete(::operator new(1, std::nothrow));
    ::operator delete[](::operator new[](1, std::nothrow));
    ::operator delete(::operator new(1, wide, std::nothrow), wide);
    ::operator delete[](::operator new[](1, wide, std::nothrow), wide);
    EXPECT_EQ(allocation_count() - before, 8u);
}

class Allocation : public testing::TestWithParam<std::tuple<SceneEntry, int>> {};

TEST_P(Allocation, DoesNotHappenInAWarmStep) {
    const auto& [entry, threads] = GetParam();
    if (const auto why = cannot_run(entry); !why.empty()) GTEST_SKIP() << why;

    constexpr int warm_up = 30, frames = 60;
    SceneRun run(entry, threads);
    std::uint64_t allocations = 0;
    for (int frame = 0; frame < warm_up + frames; ++frame) {
        run.before_step();  // the scene may allocate
        const std::uint64_t before = allocation_count();
        run.step();
        if (frame >= warm_up) allocations += allocation_count() - before;
    }
    EXPECT_EQ(allocations, 0u) << "in " << frames << " steps";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Allocation,
                         testing::Combine(testing::ValuesIn(all_scenes().begin(), all_scenes().end()),
                                          testing::Values(1, 2)),
                         [](const auto& info) {
                             return std::get<0>(info.param).name + std::string(std::get<1>(info.param) == 1
                                                                                   ? "_one_thread"
                                                                                   : "_two_threads");
                         });

}  // namespace
}  // namespace weft::demo
