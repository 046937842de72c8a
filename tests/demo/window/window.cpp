#include "tests/demo/window/window.h"

#include <chrono>
#include <thread>

namespace weft::demo {

std::optional<Screen>& Window::screen() {
    static std::optional<Screen> one;
    return one;
}

void Window::SetUp() {
    if (!screen()) GTEST_SKIP() << "Xvfb or xdotool is missing; tests/run installs them";
}

void Window::play(const char* scene, std::vector<Act> acts, const Stage& stage) {
    Options options;
    options.width = stage.across;
    options.height = stage.down;
    options.scene_options.particles = stage.particles;
    options.frames = stage.most_frames;
    options.check_gl = true;
    Overrides overrides;
    overrides.threads = 1;
    auto simulation = Simulation::create(*find_scene(scene), options.scene_options, overrides);
    ASSERT_TRUE(simulation) << simulation.error().message;
    point({0.75f, 0.4f});  // keys go to the window that the pointer is in
    std::size_t act = 0;
    const int status = run_app(options, std::move(*simulation), [&](const AppFrame& frame) {
        if (acts[act](frame)) ++act;
        return act < acts.size();
    });
    EXPECT_EQ(status, 0);
    EXPECT_EQ(act, acts.size()) << "an act that did not end";
}

Window::Act Window::wait(int pictures) {
    return [=, left = pictures](const AppFrame&) mutable { return --left <= 0; };
}

Window::Act Window::until(const std::function<bool(const AppFrame&)>& condition) {
    return [=](const AppFrame& frame) {
        std::this_thread::sleep_for(std::chrono::milliseconds(40));
        return condition(frame);
    };
}

Window::Act Window::at_once(const std::function<void(const AppFrame&)>& act) {
    return [=](const AppFrame& frame) {
        act(frame);
        return true;
    };
}

Window::Act Window::key(const std::string& name) {
    return at_once([=](const AppFrame&) { screen()->key(name); });
}

}  // namespace weft::demo
