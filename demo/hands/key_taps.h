#pragma once
// Keys that were pressed since the last picture.

#include <vector>

struct GLFWwindow;

namespace weft::demo {

/// Records key events. Polling once per picture would miss keys that go down and up in between: at three
/// pictures a second, most of them. Keys have GLFW's numbers.
class KeyTaps {
  public:
    KeyTaps() = default;
    KeyTaps(const KeyTaps&) = delete;
    KeyTaps& operator=(const KeyTaps&) = delete;

    /// Receives a window's events while both live. Precondition: the window has no ImGuiLayer yet.
    void listen_to(GLFWwindow* window);
    /// Number of presses of the key; `repeats`: includes the repeats of a held key.
    [[nodiscard]] int count(int key, bool repeats = false) const;
    [[nodiscard]] bool empty() const { return taps_.empty(); }
    void forget() { taps_.clear(); }

  private:
    struct Tap {
        int key;
        bool is_repeat;
    };
    std::vector<Tap> taps_;
};

}  // namespace weft::demo
