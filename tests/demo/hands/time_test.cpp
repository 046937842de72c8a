// Back in time, and each step twice.

#include <gtest/gtest.h>

#include <algorithm>

#include "demo/hands/hands.h"
#include "demo/time/time_bar.h"
#include "demo/time/timeline.h"
#include "tests/demo/small_world.h"

namespace weft::demo {
namespace {

constexpr float step_time = 1.0f / 60;

Simulation small_scene(const char* name) {
    return simulation_of(name, 200);
}

class Time : public testing::TestWithParam<const char*> {};

/// Twenty steps, back by twelve, and on again.
TEST_P(Time, BackAndOnAgainLeavesTheSameBytes) {
    Simulation simulation = small_scene(GetParam());
    Timeline timeline;
    std::vector<std::uint64_t> hashes;
    ASSERT_TRUE(timeline.keep(simulation));
    for (int k = 0; k < 20; ++k) {
        simulation.step(step_time);
        hashes.push_back(simulation.world().state_hash());
        ASSERT_TRUE(timeline.keep(simulation));
    }
    ASSERT_EQ(timeline.size(), 21u);
    ASSERT_TRUE(timeline.go_to(8, simulation));
    EXPECT_EQ(timeline.here(), 8u);
    EXPECT_EQ(simulation.world().state_hash(), hashes[7]);
    EXPECT_NEAR(simulation.time(), 8.0 / 60, 1e-6);
    for (std::size_t k = 8; k < 20; ++k) {
        simulation.step(step_time);
        ASSERT_EQ(simulation.world().state_hash(), hashes[k]) << "step " << k + 1;
        ASSERT_TRUE(timeline.keep(simulation));
        EXPECT_EQ(timeline.size(), k + 2) << "the other future is forgotten";
    }
}
INSTANTIATE_TEST_SUITE_P(Scenes, Time,
                         testing::Values("flag", "ribbon", "character", "ball", "meeting", "capes", "bar"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST(Timeline, KeepsWithinItsRoomTheLatest) {
    Simulation simulation = small_scene("flag");
    const std::size_t each = simulation.world().save_size();
    Timeline timeline(5 * each + 10);
    for (int k = 0; k < 12; ++k) {
        simulation.step(step_time);
        ASSERT_TRUE(timeline.keep(simulation));
        EXPECT_LE(timeline.bytes(), 5 * each + 10);
    }
    EXPECT_EQ(timeline.size(), 5u);
    EXPECT_EQ(timeline.here(), 4u);
    EXPECT_NEAR(timeline.time_of(0), 8.0 / 60, 1e-6);
    Timeline none(each - 1), one(each);
    ASSERT_TRUE(none.keep(simulation));
    EXPECT_EQ(none.size(), 0u);
    ASSERT_TRUE(one.keep(simulation));
    EXPECT_EQ(one.size(), 1u);
}

TEST(Timeline, NobodyHoldsWhatAHandHeldThen) {
    Simulation simulation = small_scene("flag");
    render::OrbitCamera camera = simulation.content().camera;
    Timeline timeline;
    Hands hands;
    WindControl wind;
    hands.begin(simulation);
    const auto pins = [&] {
        const auto positions = simulation.world().cloth(simulation.content().cloths.front().id)->positions;
        return std::ranges::count_if(positions, [](const Vec4& p) { return p.w == 0; });
    };
    const auto before = pins();
    Pointer pointer{.y = 0.45f, .left_button = true};
    for (pointer.x = 0.8f; pointer.x > 0.3f && !hands.interaction().grab().active(); pointer.x -= 0.03f) {
        hands.update({}, 1.6f, simulation, camera, wind);
        hands.update(pointer, 1.6f, simulation, camera, wind);
    }
    ASSERT_TRUE(hands.interaction().grab().active());
    hands.before_step(simulation, step_time);
    simulation.step(step_time);
    ASSERT_TRUE(timeline.keep(simulation, hands.mark()));
    EXPECT_EQ(pins(), before + 1);
    hands.update({}, 1.6f, simulation, camera, wind);
    EXPECT_EQ(pins(), before);
    const HandMark mark = timeline.mark_of(0);
    ASSERT_TRUE(hands.prepare(simulation, mark));
    ASSERT_TRUE(timeline.go_to(0, simulation));
    hands.arrive_in(simulation, mark);
    EXPECT_EQ(pins(), before);
}

TEST(Timeline, BeginsAnewWithACut) {
    Simulation simulation = small_scene("flag");
    Timeline timeline;
    for (int k = 0; k < 3; ++k) {
        simulation.step(step_time);
        ASSERT_TRUE(timeline.keep(simulation));
    }
    const Mesh& mesh = simulation.content().cloths.front().mesh;
    const std::uint32_t border = 4 * mesh.columns - 1;
    const MeshEdge edges[] = {{border, border - 1}, {border - 1, border - 2}};
    ASSERT_TRUE(simulation.cut(0, edges));
    ASSERT_EQ(simulation.cuts(), 1u);
    simulation.step(step_time);
    ASSERT_TRUE(timeline.keep(simulation));
    EXPECT_EQ(timeline.size(), 1u);
    EXPECT_EQ(timeline.bytes(), simulation.world().save_size());
    const std::uint64_t hash = simulation.world().state_hash();
    simulation.step(step_time);
    ASSERT_TRUE(timeline.go_to(0, simulation));
    EXPECT_EQ(simulation.world().state_hash(), hash);
}

TEST(RepeatCheck, FindsNothingWhereNothingDiffers) {
    Simulation simulation = small_scene("curtain"), once = small_scene("curtain");
    RepeatCheck check;
    check.enabled = true;
    const ClothId cloths[] = {simulation.content().cloths.front().id};
    for (int k = 0; k < 10; ++k) {
        simulation.before_step(step_time);
        check.step(simulation.world(), cloths, step_time);
        once.step(step_time);
    }
    EXPECT_EQ(check.checked(), 10u);
    EXPECT_FALSE(check.difference());
    EXPECT_EQ(simulation.world().state_hash(), once.world().state_hash());
    EXPECT_NE(words_of(check).find("10 steps"), std::string::npos);
}

TEST(RepeatCheck, ShowsTheFirstDifference) {
    Simulation simulation = small_scene("flags");
    RepeatCheck check;
    check.enabled = true;
    std::vector<ClothId> cloths;
    for (const SceneCloth& cloth : simulation.content().cloths) cloths.push_back(cloth.id);
    ASSERT_EQ(cloths.size(), 100u);
    for (int k = 0; k < 6; ++k) {
        if (k == 3)
            check.between = [&](World& world) {
                ASSERT_TRUE(world.move_cloth(cloths[1], {.translation = {0, 1e-4f, 0}}));
            };
        simulation.before_step(step_time);
        check.step(simulation.world(), cloths, step_time);
    }
    ASSERT_TRUE(check.difference());
    EXPECT_EQ(check.difference()->step, 4u);
    EXPECT_EQ(check.difference()->cloth, 1u);
    EXPECT_EQ(check.difference()->particle, 0u);
    EXPECT_NE(check.difference()->first, check.difference()->second);
    EXPECT_NE(words_of(check).find("step 4 differs, first in cloth 1"), std::string::npos) << words_of(check);
}

}  // namespace
}  // namespace weft::demo
