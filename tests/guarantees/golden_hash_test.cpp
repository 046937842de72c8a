// The bytes of every scene are those that were recorded: what was not meant to change a result did not.
//
// To record them again, after a change that was meant to, with WEFT_DATA set for the garment's scene:
//
//     WEFT_RECORD_HASHES=1 build/release/bin/weft_guarantees_tests --gtest_filter='*GoldenHash*'
//
// They hold for one compiler, since others order sums and pick instructions of their own, and for the
// targets of Highway that round alike: AVX2 and AVX-512.

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>

#include "tests/guarantees/allocation_count.h"
#include "tests/guarantees/golden_hashes.h"
#include "tests/guarantees/scene_run.h"
#include "tests/targets/targets.h"

namespace weft::demo {
namespace {

constexpr int hashed_frames = WEFT_GUARANTEE_FRAMES, warm_up = 30;

/// It counts allocations as well: a warm step makes none.
std::string hash_under(std::int64_t target, int threads, const SceneEntry& entry) {
    test::use_target(target);
    SceneRun run(entry, threads);
    std::uint64_t allocations = 0;
    for (int frame = 0; frame < hashed_frames; ++frame) {
        run.before_step();  // the host may allocate
        const std::uint64_t before = allocation_count();
        run.step();
        if (frame >= warm_up) allocations += allocation_count() - before;
    }
    EXPECT_EQ(allocations, 0u) << "by " << threads << " threads";
    char text[17];
    std::snprintf(text, sizeof text, "%016" PRIx64, run.world().state_hash());
    return text;
}

class GoldenHash : public testing::TestWithParam<SceneEntry> {
  protected:
    void SetUp() override {
        if (const auto why = cannot_run(GetParam()); !why.empty()) GTEST_SKIP() << why;
    }
    void TearDown() override { test::use_target(test::vector_targets().front()); }
};

void record(const SceneEntry& entry) {
    GoldenHashes golden = GoldenHashes::read(WEFT_GOLDEN_HASHES);
    golden.compiler = WEFT_COMPILER;
    golden.targets.clear();
    std::string& hash = golden.of_scene[entry.name];
    for (const std::int64_t target : test::vector_targets()) {
        if (!test::is_fused(target)) continue;
        const std::string found = hash_under(target, 2, entry);
        if (golden.targets.empty()) hash = found;
        ASSERT_EQ(found, hash) << "under " << hwy::TargetName(target);
        golden.targets.emplace_back(hwy::TargetName(target));
    }
    ASSERT_FALSE(golden.targets.empty()) << "this machine has no target for which hashes are recorded";
    ASSERT_TRUE(golden.write(WEFT_GOLDEN_HASHES)) << WEFT_GOLDEN_HASHES << " cannot be written";
}

TEST_P(GoldenHash, IsTheRecordedOne) {
    if (std::getenv("WEFT_RECORD_HASHES") != nullptr) return record(GetParam());
    const GoldenHashes golden = GoldenHashes::read(WEFT_GOLDEN_HASHES);
    if (golden.compiler != WEFT_COMPILER)
        GTEST_SKIP() << "recorded for " << golden.compiler << ", and this is " << WEFT_COMPILER;
    int threads = 2;
    for (const std::int64_t target : test::vector_targets()) {
        const char* const name = hwy::TargetName(target);
        if (std::ranges::find(golden.targets, name) == golden.targets.end()) continue;
        const auto recorded = golden.of_scene.find(GetParam().name);
        ASSERT_NE(recorded, golden.of_scene.end()) << "record it: the head of this file says how";
        EXPECT_EQ(hash_under(target, threads, GetParam()), recorded->second) << "under " << name;
        threads = 1;
    }
    if (threads == 2) GTEST_SKIP() << "this machine has none of the targets for which they were recorded";
}

INSTANTIATE_TEST_SUITE_P(Scenes, GoldenHash, testing::ValuesIn(scenes_to_run()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace weft::demo
