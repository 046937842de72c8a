// The choices for the user's own file.

#include <filesystem>

#include "tests/demo/look/panel_frames.h"
#include "tests/demo/look/seen_windows.h"

namespace weft::demo {
namespace {

class FileWindow : public PanelFrames {
  protected:
    FileWindow() {
        const Mesh sheet = *make_sheet({.rows = 9, .columns = 9, .u = {1000, 0, 0}, .v = {0, 0, -1000}});
        EXPECT_TRUE(save_obj(file_, sheet).ok());
    }
    ~FileWindow() override { std::filesystem::remove(file_); }

    Simulation hung(float unit) {
        SceneOptions options;
        options.garment = file_;
        options.unit = unit;
        return std::move(*Simulation::create(*find_scene("garment"), options, {}));
    }
    /// What a click at any place of the window asks for, from below to above: menus that open stay above.
    std::vector<const SceneEntry*> clicked(Simulation& of) {
        std::vector<const SceneEntry*> scenes;
        for (float y = 400; y > 40; y -= 12)
            for (const bool held : {false, true, false}) {
                panels.own_file = true;
                ImGui::GetIO().MousePos = {60, y};
                ImGui::GetIO().MouseDown[0] = held;
                frame(of, {1280, 800}, [] {});
                if (requests.scene != nullptr) scenes.push_back(requests.scene);
            }
        return scenes;
    }

  private:
    std::filesystem::path file_ = std::filesystem::path(testing::TempDir()) / "weft_own_file.obj";
};

TEST_F(FileWindow, IsThereForAFileAlone) {
    Simulation own = hung(0), flag = simulation();
    for (Simulation* each : {&own, &flag}) {
        panels.own_file = true;
        std::vector<Seen> seen;
        for (int k = 0; k < 4; ++k) frame(*each, {800, 600}, [&] { seen = windows_of_this_frame(); });
        EXPECT_EQ(panels.own_file, each == &own);
        EXPECT_EQ(std::ranges::count(seen, "Your file", &Seen::name), each == &own ? 1 : 0);
        expect_apart(seen, {800, 600});
    }
}

TEST_F(FileWindow, PutsTheFileOnSomebody) {
    Simulation own = hung(0);
    const std::vector<const SceneEntry*> scenes = clicked(own);
    ASSERT_FALSE(scenes.empty());
    EXPECT_EQ(scenes.front(), find_scene("character"));
}

TEST_F(FileWindow, TheUnitIsTheUsers) {
    Simulation own = hung(0.0005f);
    const Bounds box = own.world().cloth(own.content().cloths.front().id)->bounds;
    EXPECT_NEAR(box.upper.y - box.lower.y, 0.5f, 1e-3f);
    EXPECT_TRUE(own.content().notes.empty()) << "nothing was guessed";
}

}  // namespace
}  // namespace weft::demo
