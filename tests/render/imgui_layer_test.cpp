#include "weft/render/imgui_layer.h"

#include <imgui.h>

#include <cstdlib>

#include "drawing.h"

namespace weft::render {
namespace {

using ImguiLayer = Drawing;

TEST_F(ImguiLayer, PanelsAreDrawnOverTheSceneWhereTheyStand) {
    ImGuiLayer layer(context());
    const View view;
    const Image bare = renderer().capture(view, 320, 200);
    const Image image = renderer().capture(view, 320, 200, [&] {
        layer.begin(320, 200, 1.0f / 60);
        ImGui::SetNextWindowPos({20, 10});
        ImGui::SetNextWindowSize({150, 100});
        ImGui::Begin("Panel");
        ImGui::TextUnformatted("text");
        ImGui::End();
        layer.end();
    });
    EXPECT_LT(pixel(image, 100, 90).light() + 100, pixel(bare, 100, 90).light()) << "a dark panel";
    EXPECT_EQ(pixel(image, 300, 150).light(), pixel(bare, 300, 150).light());
    EXPECT_FALSE(layer.wants_mouse());
    EXPECT_EQ(renderer().capture(view, 320, 200).rgb, bare.rgb) << "the panel's state leaks into the scene";
}

TEST_F(ImguiLayer, OneMayFollowAnother) {
    for (int i = 0; i < 2; ++i) {
        ImGuiLayer layer(context());
        layer.begin(64, 48, 0);
        EXPECT_EQ(ImGui::GetIO().DisplaySize.y, 48.0f);
        layer.end();
    }
    EXPECT_EQ(ImGui::GetCurrentContext(), nullptr);
}

TEST_F(ImguiLayer, LeavesAHostsOwnContextAlone) {
    ImGuiContext* const host = ImGui::CreateContext();
    ImGui::SetCurrentContext(host);
    const char* const settings_file = ImGui::GetIO().IniFilename;
    const float rounding = ImGui::GetStyle().WindowRounding = 3.25f;
    {
        ImGuiLayer layer(context());
        EXPECT_EQ(ImGui::GetCurrentContext(), host);
        for (int frame = 0; frame < 2; ++frame) {
            layer.begin(320, 200, 1.0f / 60);
            EXPECT_NE(ImGui::GetCurrentContext(), host);
            EXPECT_EQ(ImGui::GetIO().DisplaySize.x, 320.0f);
            EXPECT_FALSE(layer.wants_mouse() || layer.wants_keyboard());
            layer.end();
            EXPECT_EQ(ImGui::GetCurrentContext(), host);
            EXPECT_FALSE(layer.wants_mouse() || layer.wants_keyboard());
            EXPECT_EQ(ImGui::GetCurrentContext(), host);
        }
        ImGuiLayer moved = std::move(layer);
        moved.begin(64, 48, 1.0f / 60);  // and its end never comes
    }
    EXPECT_EQ(ImGui::GetCurrentContext(), host);
    EXPECT_EQ(ImGui::GetIO().IniFilename, settings_file);
    EXPECT_EQ(ImGui::GetIO().Fonts->Fonts.Size, 0) << "the host's atlas";
    EXPECT_EQ(ImGui::GetStyle().WindowRounding, rounding);
    EXPECT_EQ(ImGui::GetIO().BackendRendererUserData, nullptr);
    ImGui::DestroyContext(host);
}

}  // namespace
}  // namespace weft::render
