// The same bytes for any number of threads, whoever's they are. Golden hashes hold those of one and two
// threads.

#include <gtest/gtest.h>

#ifdef WEFT_ON_TBB
#include <tbb/global_control.h>
#endif

#include "tests/guarantees/scene_run.h"

namespace weft::demo {
namespace {

constexpr int frames = WEFT_GUARANTEE_FRAMES / 3;  // golden hashes hold all of them

// A host's executor of one thread, from the last block to the first. It claims two, since of one it would not
// be called.
constexpr Executor backward_executor{.run =
                                         [](void*, std::uint32_t count, Executor::Body body, void* context) {
                                             for (std::uint32_t i = count; i-- > 0;) body(context, i);
                                         },
                                     .width = 2};

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
    EXPECT_EQ(hash_after_all_frames(SceneRun(GetParam(), 7)),
              hash_after_all_frames(SceneRun(GetParam(), backward_executor)))
        << "7 threads, and the host's executor, which goes backwards";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Determinism, testing::ValuesIn(scenes_to_run()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace weft::demo
