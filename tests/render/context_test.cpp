#include "weft/render/context.h"

#include <glad/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>

#include "drawing.h"

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

}  // namespace
}  // namespace weft::render
