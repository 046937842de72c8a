// The same bytes for any number of threads, whoever's they are.

#include <gtest/gtest.h>

#ifdef WEFT_ON_TBB
#include <tbb/global_control.h>
#endif

#include "tests/guarantees/scene_run.h"

namespace weft::demo {
namespace {

constexpr int frames = WEFT_GUARANTEE_FRAMES;

// A host's executor of one thread that claims two, since a width of one would not be called at all.
template <bool backwards>
constexpr Executor serial_executor() {
    return {.run =
                [](void*, std::uint32_t count, Executor::Body body, void* context) {
                    for (std::uint32_t i = 0; i < count; ++i) body(context, backwards ? count - 1 - i : i);
                },
            .width = 2};
}

std::uint64_t hash_after_all_frames(SceneRun run) {
    for (int frame = 0; frame < frames; ++frame) {
        run.before_step();
        run.step();
    }
    return run.world().state_hash();
}

class Determinism : public testing::TestWithParam<SceneEntry> {
  protected:
    void SetUp() override {
        if (const auto why = cannot_run(GetParam()); !why.empty()) GTEST_SKIP() << why;
    }

  private:
#ifdef WEFT_ON_TBB
    // Without it oneTBB starts no more threads than there are cores, and eight threads would be two.
    tbb::global_control many_threads_{tbb::global_control::max_allowed_parallelism, 8};
#endif
};

TEST_P(Determinism, GivesTheSameBytesForAnyThreads) {
    const std::uint64_t expected = hash_after_all_frames(SceneRun(GetParam(), 1));
    for (const int threads : {2, 7})
        EXPECT_EQ(hash_after_all_frames(SceneRun(GetParam(), threads)), expected) << threads << " threads";
    EXPECT_EQ(hash_after_all_frames(SceneRun(GetParam(), serial_executor<false>())), expected)
        << "the host's serial executor";
    EXPECT_EQ(hash_after_all_frames(SceneRun(GetParam(), serial_executor<true>())), expected)
        << "the host's serial executor, backwards";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Determinism, testing::ValuesIn(scenes_to_run()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace weft::demo
