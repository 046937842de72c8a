// Every scene, recorded and stepped again on other threads: the same bytes after each step.

#include <gtest/gtest.h>

#include <vector>

#include "tests/guarantees/scene_run.h"

namespace weft::demo {
namespace {

constexpr int recorded_frames = 20;

class ReplayOfScenes : public testing::TestWithParam<SceneEntry> {
  protected:
    void SetUp() override {
        if (const auto why = cannot_run(GetParam()); !why.empty()) GTEST_SKIP() << why;
    }
};

TEST_P(ReplayOfScenes, HasTheSameBytesInEveryStep) {
    std::vector<std::byte> recorded;
    const RecordingSink sink{[](void* to, std::span<const std::byte> more) {
                                 auto& bytes = *static_cast<std::vector<std::byte>*>(to);
                                 bytes.insert(bytes.end(), more.begin(), more.end());
                                 return true;
                             },
                             &recorded};
    {
        SceneRun run(GetParam(), sink);
        for (int frame = 0; frame < recorded_frames; ++frame) {
            run.before_step();
            run.step();
        }
        ASSERT_TRUE(run.world().stop_recording());
    }
    const auto replayed = replay(recorded, {.threads = 3});
    ASSERT_TRUE(replayed) << replayed.error().message;
    EXPECT_TRUE(replayed->is_whole);
    EXPECT_EQ(replayed->steps, static_cast<std::uint64_t>(recorded_frames));
    EXPECT_FALSE(replayed->difference)
        << "step " << replayed->difference->step << ", cloth "
        << (replayed->difference->cloth ? std::to_string(*replayed->difference->cloth) : "none");
}

INSTANTIATE_TEST_SUITE_P(Scenes, ReplayOfScenes, testing::ValuesIn(scenes_to_run()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace weft::demo
