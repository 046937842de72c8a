// Contexts, and Dear ImGui within them.

#include <glad/gl.h>
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <array>
#include <cstdlib>

#include "drawing.h"
#include "weft/render/context.h"
#include "weft/render/imgui_layer.h"

#define GLFW_INCLUDE_NONE

namespace weft::render {

namespace {

using Contexts = Drawing;

TEST_F(Contexts, OffscreenIsCurrentAndAtLeast33Core) {
    GLint major = 0, minor = 0, profile = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_GE(10 * major + minor, 33);
    EXPECT_EQ(profile & GL_CONTEXT_CORE_PROFILE_BIT, GL_CONTEXT_CORE_PROFILE_BIT);
    EXPECT_EQ(context().window_handle(), nullptr);
    EXPECT_NE(context().renderer().find("OpenGL"), std::string::npos);
}

TEST_F(Contexts, AnotherOneDrawsAfterTheFirstIsGone) {
    const View view;
    const Image first = renderer().capture(view, 64, 48);
    TearDown();
    SetUp();
    EXPECT_EQ(renderer().capture(view, 64, 48).rgb, first.rgb);
}

TEST_F(Contexts, ACheckedOneTellsWhatTheDriverObjectsTo) {
    EXPECT_TRUE(context().take_complaints().empty());
    glEnable(0x7777);  // no capability
    glEnable(0x7777);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
    if (GLAD_GL_KHR_debug == 0) GTEST_SKIP() << "the driver lacks KHR_debug";
    EXPECT_EQ(context().take_complaints().size(), 1u);
    EXPECT_TRUE(context().take_complaints().empty());
    TearDown();
    auto unchecked = Context::offscreen();
    ASSERT_TRUE(unchecked.ok());
    glEnable(0x7777);
    EXPECT_TRUE(unchecked->take_complaints().empty());
}

TEST_F(Contexts, WhatADriverSaysOfSpeedIsNoComplaint) {
    if (GLAD_GL_KHR_debug == 0) GTEST_SKIP() << "the driver lacks KHR_debug";
    const auto say = [](GLenum type, const char* text) {
        glDebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, type, 1, GL_DEBUG_SEVERITY_MEDIUM, -1, text);
    };
    say(GL_DEBUG_TYPE_PERFORMANCE, "a shader is compiled once more");
    say(GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR, "nobody knows");
    EXPECT_EQ(context().take_complaints(), std::vector<std::string>{"nobody knows"});
}

TEST(Window, ASizeBelowOnePixelIsNamed) {
    for (const auto& [width, height] : {std::array{0, 100}, std::array{100, -3}}) {
        const auto made = Context::window({.width = width, .height = height, .title = "", .vsync = false});
        ASSERT_FALSE(made);
        EXPECT_NE(made.error().message.find(width < 1 ? "width" : "height"), std::string::npos);
    }
}

TEST_F(Contexts, AWindowShowsTheSamePictureAsACapture) {
    View view;
    const Image expected = renderer().capture(view, 320, 200);
    TearDown();  // one context at a time
    auto opened = Context::window({.width = 320, .height = 200, .title = "Weft test", .vsync = false});
    if (!opened) GTEST_SKIP() << opened.error().message;
    int width = 0, height = 0;
    glfwGetFramebufferSize(opened->window_handle(), &width, &height);
    if (width != 320 || height != 200) GTEST_SKIP() << "the window manager chose another size";
    auto on_screen = SceneRenderer::create();
    ASSERT_TRUE(on_screen) << on_screen.error().message;
    on_screen->draw(view, width, height);
    std::array<std::uint8_t, 4> corner{};
    glReadPixels(160, 199 - 20, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, corner.data());
    const Pixel there = pixel(expected, 160, 20);
    EXPECT_NEAR(corner[0], there.red, 2);
    EXPECT_NEAR(corner[1], there.green, 2);
    EXPECT_NEAR(corner[2], there.blue, 2);
}

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
