// What the panels show, as far as it needs no picture.

#include "demo/panels/panels.h"

#include <gtest/gtest.h>

#include "demo/hands/hands.h"
#include "demo/headless/report_text.h"
#include "demo/options/method_table.h"
#include "demo/panels/widgets.h"

namespace weft::demo {
namespace {

/// Dear ImGui without a picture: frames are built, and the pointer is where the test says.
class Widgets : public testing::Test {
  protected:
    Widgets() {
        ImGui::SetCurrentContext(context);
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {1280, 800};
        io.DeltaTime = 1.0f / 60;
        unsigned char* pixels = nullptr;
        int across = 0, down = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &across, &down);
    }
    ~Widgets() override { ImGui::DestroyContext(context); }

    template <class Build>
    static void frame(const Build& build) {
        ImGui::NewFrame();
        build();
        ImGui::Render();
    }

    ImGuiContext* context = ImGui::CreateContext();
};

TEST_F(Widgets, ASliderReachesTheValueThatItWasGiven) {
    float number = 50;
    int count = 50;
    ImVec2 right_end[2];
    const auto both = [&] {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({400, 200});
        ImGui::Begin("panel");
        slider("number", number, 0, 10, "%.1f", "");
        right_end[0] = {ImGui::GetItemRectMin().x + ImGui::CalcItemWidth() - 4,
                        ImGui::GetItemRectMin().y + 4};
        slider("count", count, 0, 10, "%d", "");
        right_end[1] = {ImGui::GetItemRectMin().x + ImGui::CalcItemWidth() - 4,
                        ImGui::GetItemRectMin().y + 4};
        ImGui::End();
    };
    frame(both);
    frame(both);
    EXPECT_EQ(number, 50);
    EXPECT_EQ(count, 50);
    const auto drag = [&](ImVec2 from, ImVec2 to) {
        for (const auto& [place, held] : {std::pair(from, false), std::pair(from, true), std::pair(to, true),
                                          std::pair(to, true), std::pair(to, false)}) {
            ImGui::GetIO().MousePos = place;
            ImGui::GetIO().MouseDown[0] = held;
            frame(both);
        }
    };
    for (const ImVec2& end : right_end) drag({end.x - 100, end.y}, {end.x - 150, end.y});
    EXPECT_LT(number, 40);
    EXPECT_LT(count, 40);
    for (const ImVec2& end : right_end) drag({end.x - 50, end.y}, end);
    EXPECT_EQ(number, 50);
    EXPECT_EQ(count, 50);
}

TEST_F(Widgets, PanelsLeaveAloneWhatTheCommandLineAskedFor) {
    SceneOptions options;
    options.particles = 100;
    Overrides overrides;
    overrides.wind = Vec3{60, 5, -70};
    overrides.method = Xpbd{};
    overrides.iterations = 10000;
    overrides.substeps = 256;
    overrides.threads = 256;
    auto simulation = Simulation::create(*find_scene("flag"), options, overrides);
    ASSERT_TRUE(simulation.ok()) << simulation.error().message;
    WindControl wind(*overrides.wind);
    wind.steer(0, 0, 1);
    Playback playback;
    Hands hands;
    Panels panels;
    for (int i = 0; i < 3; ++i)
        frame([&] { (void)panels.draw(*simulation, wind, hands, playback, simulation->content().camera); });
    EXPECT_EQ(panels.message, "");
    EXPECT_NEAR(wind.velocity().x, 60, 1e-3);
    EXPECT_NEAR(wind.velocity().z, -70, 1e-3);
    const WorldSettings& world = simulation->world().settings();
    EXPECT_EQ(world.wind.velocity.x, 60);
    EXPECT_EQ(world.substeps, 256);
    EXPECT_EQ(world.threads, 256);
    EXPECT_EQ(
        iterations_of(simulation->world().cloth_settings(simulation->content().cloths.front().id)->method),
        10000);
}

TEST(Panels, SayWhatAClothRefuses) {
    SceneOptions options;
    options.particles = 100;
    auto simulation = Simulation::create(*find_scene("flag"), options, {});
    ASSERT_TRUE(simulation.ok());
    ClothSettings settings = *simulation->world().cloth_settings(simulation->content().cloths.front().id);
    EXPECT_TRUE(set_all_cloths(*simulation, settings).ok());
    settings.fabric.warp = -1;
    const auto refused = set_all_cloths(*simulation, settings);
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().message.find("warp"), std::string::npos) << refused.error().message;
}

TEST(FlagsText, NamesTheSettingToChange) {
    EXPECT_EQ(flags_text(StepFlags::none, 0), "");
    EXPECT_NE(flags_text(StepFlags::state_restored, 0).find("substeps"), std::string::npos);
    EXPECT_NE(flags_text(StepFlags::contacts_dropped, 0).find("layers"), std::string::npos);
    const std::string both = flags_text(StepFlags::state_restored | StepFlags::contacts_dropped, 0);
    EXPECT_EQ(both, flags_text(StepFlags::state_restored, 0) + flags_text(StepFlags::contacts_dropped, 0));
}

}  // namespace
}  // namespace weft::demo
