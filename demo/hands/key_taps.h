#pragma once
// Keys that were pressed since the last picture.

#include <vector>

struct GLFWwindow;

namespace weft::demo {

/// Asked for at each picture, a key that went down and up in between would be missed: at three pictures a
/// second that is most of them. Keys have GLFW's numbers.
class KeyTaps {
  public:
    KeyTaps() = default;
    KeyTaps(const KeyTaps&) = delete;
    KeyTaps& operator=(const KeyTaps&) = delete;

    /// Listens to a window, before an ImGuiLayer does, as long as both live.
    void listen_to(GLFWwindow* window);
    /// How often the key was pressed; `repeats`: by being held, too.
    [[nodiscard]] int count(int key, bool repeats = false) const;
    void forget() { taps_.clear(); }

  private:
    struct Tap {
        int key;
        bool is_repeat;
    };
    std::vector<Tap> taps_;
};

}  // namespace weft::demo
