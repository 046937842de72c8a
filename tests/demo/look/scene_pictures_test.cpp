// Scenes as the demo's list shows them: from the first step to the pixel. Those pictures are made by
// demo/pictures/scenes/make.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "tests/render/stored/perceptual.h"

namespace weft::demo {
namespace {

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
