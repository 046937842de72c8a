#include "tests/demo/window/window.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>
#include <utility>

namespace weft::demo {

namespace {

bool is_installed(const std::string& program) {
    return std::system(("command -v " + program + " > /dev/null").c_str()) == 0;
}

/// The number of the display that Xvfb says it has; empty where it says none.
std::string read_line(int from) {
    std::string line;
    for (char c = 0; read(from, &c, 1) == 1 && c != '\n';) line += c;
    return line;
}

}  // namespace

std::optional<Screen> Screen::start() {
    if (!is_installed("Xvfb") || !is_installed("xdotool")) return std::nullopt;
    int ends[2];
    if (pipe(ends) != 0) return std::nullopt;
    const int process = fork();
    if (process == 0) {
        const std::string said_to = std::to_string(ends[1]);
        close(ends[0]);
        // Without -noreset it begins anew when a window closes, and the next one may find nobody there.
        execlp("Xvfb", "Xvfb", "-displayfd", said_to.c_str(), "-screen", "0", "2560x1440x24", "-nolisten",
               "tcp", "-noreset", nullptr);
        _exit(127);
    }
    close(ends[1]);
    const std::string number = read_line(ends[0]);
    close(ends[0]);
    Screen screen(process);
    if (number.empty()) return std::nullopt;
    setenv("DISPLAY", (":" + number).c_str(), 1);
    return screen;
}

Screen::Screen(Screen&& other) noexcept : process_(std::exchange(other.process_, 0)) {}

Screen::~Screen() {
    if (process_ <= 0) return;
    kill(process_, SIGTERM);
    waitpid(process_, nullptr, 0);
    unsetenv("DISPLAY");
}

void Screen::move_pointer(float x, float y) const {
    run("mousemove " + std::to_string(static_cast<int>(x)) + ' ' + std::to_string(static_cast<int>(y)));
}

void Screen::resize(int width, int height) const {
    run("search --name Weft windowsize %@ " + std::to_string(width) + ' ' + std::to_string(height));
}

void Screen::run(const std::string& command) const {
    (void)!std::system(("xdotool " + command).c_str());
}

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
    options.compare = stage.compare;
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
