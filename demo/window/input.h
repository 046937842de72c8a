#pragma once
// Taps of keys, and files that are dropped on the window.

#include <filesystem>
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

/// Begins to remember files that are dropped on the window.
void remember_dropped_files(GLFWwindow* window);
/// The files dropped since the last call.
[[nodiscard]] std::vector<std::filesystem::path> take_dropped_files();

/// The kind of a file, by its extension. A glTF file with a skin is a character, else a garment.
enum class FileKind { settings, garment, character, unknown };
[[nodiscard]] FileKind kind_of(const std::filesystem::path& file);

}  // namespace weft::demo
