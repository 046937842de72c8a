// The gallery of scenes, clicked at by a user who sees no pictures.

#include <imgui_internal.h>

#include <algorithm>
#include <set>
#include <string>

#include "tests/demo/look/panel_frames.h"

namespace weft::demo {
namespace {

class Gallery : public PanelFrames {
  protected:
    /// The scene that a click starts; null: none.
    const SceneEntry* click(Simulation& of, ImVec2 size, ImVec2 place) {
        panels.gallery = true;
        const SceneEntry* started = nullptr;
        ImGui::GetIO().MousePos = place;
        for (const bool held : {false, true, false}) {
            ImGui::GetIO().MouseDown[0] = held;
            frame(of, size, [] {});
            if (requests.scene != nullptr) started = requests.scene;
        }
        return started;
    }
    /// How far the gallery has scrolled down when it opens [pixels].
    float scrolled(const char* scene) {
        Simulation of = simulation(scene);
        panels.gallery = false;
        frame(of, {800, 600}, [] {});
        panels.gallery = true;
        for (int k = 0; k < 4; ++k) frame(of, {800, 600}, [] {});
        return ImGui::FindWindowByName("Scenes")->Scroll.y;
    }
};

TEST_F(Gallery, HasACardForEveryScene) {
    Simulation of = simulation("flag", 60);
    std::set<std::string> started;
    std::size_t in_lab = 0;
    for (float y = 30; y < 1340; y += 70)
        for (float x = 30; x < 2200; x += 70)
            if (const SceneEntry* scene = click(of, {2560, 1440}, {x, y})) {
                EXPECT_FALSE(panels.gallery) << "it closes";
                if (started.insert(scene->name).second && scene->group == SceneGroup::lab) ++in_lab;
            }
    for (const SceneEntry& entry : all_scenes())
        EXPECT_TRUE(started.contains(entry.name) || entry.group == SceneGroup::lab) << entry.name;
    EXPECT_EQ(in_lab, 1u) << "the contact lab has one card";
}

TEST_F(Gallery, ShowsTheChosenScene) {
    EXPECT_EQ(scrolled("flag"), 0);
    EXPECT_GT(scrolled("bench"), 300);
}

}  // namespace
}  // namespace weft::demo
