#pragma once
// The real window, with real events, on a screen that nobody sees (Xvfb and xdotool).

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "demo/window/app.h"

namespace weft::demo {

/// Starts Xvfb and makes it this process's display, as long as it lives.
class Screen {
  public:
    /// None where Xvfb or xdotool is not installed, or does not start.
    static std::optional<Screen> start();
    Screen(Screen&& other) noexcept;
    Screen& operator=(Screen&& other) noexcept {
        std::swap(process_, other.process_);
        return *this;
    }
    ~Screen();

    // All of them wait until the event was given to the window system. Places in pixels of the screen, whose
    // upper left corner is the window's: there is no window manager.
    void move_pointer(float x, float y) const;
    void press() const { run("mousedown 1"); }
    void release() const { run("mouseup 1"); }
    /// The program's window, as somebody who drags its corner.
    void resize(int width, int height) const;
    void key(const std::string& name) const { run("key " + name); }
    void hold(const std::string& name) const { run("keydown " + name); }
    void let_go(const std::string& name) const { run("keyup " + name); }

  private:
    explicit Screen(int process) : process_(process) {}
    void run(const std::string& command) const;
    int process_;
};

// The real window on a real display, with real events, in acts.

/// A play in acts: each is called after every picture until it says that it is over. The driver checks every
/// call, and what it objects to makes the program fail.
class Window : public testing::Test {
  protected:
    using Act = std::function<bool(const AppFrame&)>;
    struct Stage {
        int across = 480, down = 320;
        int most_frames = 250;
        std::uint32_t particles = 300;
        std::optional<Method> compare{};
    };
    static constexpr float aspect = 480.0f / 320;

    static void SetUpTestSuite() { screen() = Screen::start(); }
    static void TearDownTestSuite() { screen().reset(); }
    static std::optional<Screen>& screen();
    void SetUp() override;

    static void play(const char* scene, std::vector<Act> acts, const Stage& stage);
    static void play(const char* scene, std::vector<Act> acts) { play(scene, std::move(acts), Stage()); }
    /// Waits for some pictures: events come by the window system.
    static Act wait(int pictures);
    /// Waits without drawing more than it must.
    static Act until(const std::function<bool(const AppFrame&)>& condition);
    /// In heights of the picture, of a window of the usual size.
    static void point(Vec2 place) { screen()->move_pointer(320 * place.x, 320 * place.y); }
    static Act at_once(const std::function<void(const AppFrame&)>& act);
    static Act key(const std::string& name);

    static ClothView first_cloth(const AppFrame& frame) {
        return *frame.simulation.world().cloth(frame.simulation.content().cloths.front().id);
    }
};

}  // namespace weft::demo
