// Every scene's own check, after as many steps as it asks for.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

#include "demo/scene_simulation.h"
#include "tests/demo/garments.h"
#include "tests/render/stored/perceptual.h"

namespace weft::demo {

namespace {

/// Runs the scene and returns what its check finds.
Result<void> run_and_check(const SceneEntry& entry, const SceneOptions& options) {
    auto simulation = Simulation::create(entry, options, {});
    if (!simulation) return simulation.error();
    const int steps = simulation->scene().check_steps();
    for (int i = 0; i < steps; ++i) {
        const StepReport& report = simulation->step(1.0f / 60.0f);
        EXPECT_FALSE(has(report.flags, StepFlags::state_restored)) << "in step " << i;
    }
    return simulation->scene().check(simulation->world());
}

class SceneCheck : public testing::TestWithParam<const char*> {};

TEST_P(SceneCheck, Holds) {
    const SceneEntry* entry = find_scene(GetParam());
    ASSERT_NE(entry, nullptr);
    const auto checked = run_and_check(*entry, {});
    EXPECT_TRUE(checked.ok()) << checked.error().message;
}

std::vector<const char*> scenes_without_files() {
    std::vector<const char*> names;
    for (const SceneEntry& entry : all_scenes()) {
        if (!entry.needs_garment) names.push_back(entry.name);
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(Scenes, SceneCheck, testing::ValuesIn(scenes_without_files()),
                         [](const auto& scene) { return std::string(scene.param); });

class GarmentCheck : public testing::TestWithParam<const char*> {};

TEST_P(GarmentCheck, Holds) {
    WEFT_NEEDS_DATA();
    SceneOptions options;
    options.garment = data_folder() / "garments" / (std::string(GetParam()) + ".obj");
    const auto checked = run_and_check(*find_scene("garment"), options);
    EXPECT_TRUE(checked.ok()) << checked.error().message;
}

INSTANTIATE_TEST_SUITE_P(Garments, GarmentCheck, testing::Values("skirt-iso", "dress-victor-iso-draped"),
                         [](const auto& garment) {
                             const std::string name = garment.param;
                             return name.substr(0, name.find('-'));
                         });

TEST(Scenes, AreFoundByTheirNamesAndNoOthers) {
    std::set<std::string> names;
    for (const SceneEntry& entry : all_scenes()) {
        EXPECT_EQ(find_scene(entry.name), &entry);
        EXPECT_TRUE(names.insert(entry.name).second) << entry.name << " is listed twice";
    }
    EXPECT_EQ(find_scene("no such scene"), nullptr);
    EXPECT_EQ(find_scene(""), nullptr);
}

TEST(Scenes, AreListedGroupByGroupWithASentenceEach) {
    SceneGroup group = all_scenes().front().group;
    for (const SceneEntry& entry : all_scenes()) {
        EXPECT_GE(entry.group, group) << entry.name;
        group = entry.group;
        const std::string sentence = entry.description;
        EXPECT_EQ(sentence.find('.'), sentence.size() - 1) << sentence;
        EXPECT_LE(sentence.size(), 75u) << "it has three lines of a card: " << sentence;
    }
    EXPECT_GE(std::ranges::count(all_scenes(), SceneGroup::lab, &SceneEntry::group), 10);
}

struct Rest {
    const char* scene;
    int steps;
};
class RestingScene : public testing::TestWithParam<Rest> {};

TEST_P(RestingScene, IsStill) {
    auto simulation = Simulation::create(*find_scene(GetParam().scene), {}, {});
    ASSERT_TRUE(simulation.ok()) << simulation.error().message;
    for (int step = 0; step < GetParam().steps; ++step) simulation->step(1.0f / 60);
    for (const SceneCloth& cloth : simulation->content().cloths)
        EXPECT_TRUE(*simulation->world().is_asleep(cloth.id)) << "cloth " << cloth.id.index;
}

INSTANTIATE_TEST_SUITE_P(Scenes, RestingScene,
                         testing::Values(Rest{"sheet", 360}, Rest{"ribbon", 360}, Rest{"layers", 360},
                                         Rest{"crumple", 720}),
                         [](const auto& each) { return std::string(each.param.scene); });

TEST(Scenes, AskForAGarmentThatIsMissing) {
    const auto without = Simulation::create(*find_scene("garment"), {}, {});
    ASSERT_FALSE(without.ok());
    EXPECT_NE(without.error().message.find("--garment"), std::string::npos) << without.error().message;
}

TEST(Scenes, OfFewParticlesCanBeBuilt) {
    for (const char* name : scenes_without_files()) {
        for (const std::uint32_t particles : {9u, 60u, 300u}) {
            SceneOptions options;
            options.particles = particles;
            const auto simulation = Simulation::create(*find_scene(name), options, {});
            EXPECT_TRUE(simulation.ok()) << name << ": " << simulation.error().message;
        }
    }
}

class ScaledScene : public testing::TestWithParam<const char*> {};

TEST_P(ScaledScene, HasAboutAsManyParticlesAsAskedFor) {
    if (GetParam() == std::string_view("bench")) GTEST_SKIP() << "its pieces are of the testers' own sizes";
    for (const std::uint32_t particles : {400u, 6000u}) {
        if (GetParam() == std::string_view("flags") && particles < 1000) continue;  // a hundred of six each
        SceneOptions options;
        options.particles = particles;
        auto simulation = Simulation::create(*find_scene(GetParam()), options, {});
        ASSERT_TRUE(simulation.ok()) << simulation.error().message;
        std::uint32_t all = 0;
        for (const SceneCloth& cloth : simulation->content().cloths)
            all += simulation->world().cloth_info(cloth.id)->particles;
        // On the stage of contact folds lie between cells, and cloths share alike.
        const std::string name = GetParam();
        const bool is_plain = name == "flag" || name == "curtain" || name == "sheet" || name == "ribbon";
        EXPECT_NEAR(all, particles, (is_plain ? 0.12 : 0.25) * particles);
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, ScaledScene, testing::ValuesIn(scenes_without_files()),
                         [](const auto& scene) { return std::string(scene.param); });

// Scenes as the demo's list shows them: from the first step to the pixel. Those pictures are made by
// demo/pictures/scenes/make.

struct Shown {
    const char* scene;
    int frames;  ///< as make has them
};

class ScenePicture : public testing::TestWithParam<Shown> {};

TEST_P(ScenePicture, IsTheStoredOne) {
    const auto& [scene, frames] = GetParam();
    const auto out = std::filesystem::path(testing::TempDir()) / (std::string("weft_picture_of_") + scene);
    const std::string command = std::string(WEFT_DEMO_PROGRAM) + " --headless --size 512x320 --scene " +
                                scene + " --frames " + std::to_string(frames) + " --out " + out.string() +
                                " >/dev/null";
    ASSERT_EQ(std::system(command.c_str()), 0);
    const render::Image now = render::smaller(render::load_png((out / "final.png").string()), 4);
    std::filesystem::remove_all(out);
    const render::Image stored = render::load_png(std::string(WEFT_SCENE_PICTURES) + "/" + scene + ".png");
    ASSERT_EQ(now.rgb.size(), stored.rgb.size());
    const auto difference = render::perceptual_difference(now, stored);
    EXPECT_FALSE(difference.is_noticed())
        << difference.words() << "; if it should be so, look at it: demo/pictures/scenes/make " << scene;
}

INSTANTIATE_TEST_SUITE_P(Scenes, ScenePicture,
                         testing::Values(Shown{"bench", 150}, Shown{"curtain", 150}, Shown{"ball", 60}),
                         [](const auto& each) { return std::string(each.param.scene); });

}  // namespace

}  // namespace weft::demo
