#pragma once
// A screen that nobody sees, and hands on its mouse and keys: Xvfb and xdotool.

#include <optional>
#include <string>
#include <utility>

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

}  // namespace weft::demo
