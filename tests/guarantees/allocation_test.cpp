// World::step does not allocate once it is warm.

#include <gtest/gtest.h>

#include <new>
#include <string>
#include <tuple>

#include "tests/guarantees/allocation_count.h"
#include "tests/guarantees/method_cases.h"
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

struct WarmSteps {
    std::uint64_t count = 0;  ///< of allocations
    std::uint32_t collider_contacts = 0, self_contacts = 0, restored = 0;
};

/// Of 60 steps, after 30 to warm up.
template <class Run>
WarmSteps allocations_when_warm(Run& run) {
    constexpr int warm_up = 30, frames = 60;
    WarmSteps seen;
    for (int frame = 0; frame < warm_up + frames; ++frame) {
        run.before_step();  // the host may allocate
        const std::uint64_t before = allocation_count();
        const StepReport& report = run.step();
        if (frame < warm_up) continue;
        seen.count += allocation_count() - before;
        seen.collider_contacts += report.collider_contacts;
        seen.self_contacts += report.self_contacts;
        seen.restored += report.restored_cloths;
    }
    return seen;
}

class Allocation : public testing::TestWithParam<std::tuple<SceneEntry, int>> {};

TEST_P(Allocation, DoesNotHappenInAWarmStep) {
    const auto& [entry, threads] = GetParam();
    if (const auto why = cannot_run(entry); !why.empty()) GTEST_SKIP() << why;

    SceneRun run(entry, threads);
    EXPECT_EQ(allocations_when_warm(run).count, 0u);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Allocation,
                         testing::Combine(testing::ValuesIn(scenes_to_run()), testing::Values(1, 2)),
                         [](const auto& info) {
                             return std::get<0>(info.param).name + std::string(std::get<1>(info.param) == 1
                                                                                   ? "_one_thread"
                                                                                   : "_two_threads");
                         });

class MethodAllocation : public testing::TestWithParam<test::MethodCase> {};

TEST_P(MethodAllocation, DoesNotHappenInAWarmStepWhateverIsPinned) {
    constexpr std::uint32_t side = 24;
    const SelfCollision& self = GetParam().cloth.self_collision;
    const bool is_slow = self.enabled && self.method == SelfCollisionMethod::contact;
    for (const test::PinPattern& pins : test::pin_patterns(side)) {
        std::uint64_t hash = 0;
        const bool is_rest = pins.name != "corners" && pins.name != "random";
        if (is_slow && pins.name != "corners") continue;  // what it keeps does not depend on pins
        for (int threads = 1; threads <= (is_rest ? 1 : 2); ++threads) {
            SCOPED_TRACE(pins.name + ", " + std::to_string(threads) + " threads");
            test::LoweredSheet run(GetParam(), threads, side, pins);
            const WarmSteps seen = allocations_when_warm(run);
            EXPECT_EQ(seen.count, 0u);
            EXPECT_EQ(seen.restored, 0u);
            EXPECT_GT(seen.collider_contacts, 0u);
            if (self.enabled && pins.name == "corners") {
                EXPECT_GT(seen.self_contacts, 0u);
            }
            if (threads == 1) hash = run.world().state_hash();
            EXPECT_EQ(run.world().state_hash(), hash);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, MethodAllocation, testing::ValuesIn(test::method_cases()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace weft::demo
