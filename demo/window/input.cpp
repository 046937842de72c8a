#include "demo/window/input.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>

#include "demo/character/garment/gltf_file.h"

namespace weft::demo {

void KeyTaps::listen_to(GLFWwindow* window) {
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, [](GLFWwindow* from, int key, int /*code*/, int action, int /*modifiers*/) {
        if (action == GLFW_RELEASE) return;
        static_cast<KeyTaps*>(glfwGetWindowUserPointer(from))->taps_.push_back({key, action == GLFW_REPEAT});
    });
}

int KeyTaps::count(int key, bool repeats) const {
    return static_cast<int>(std::ranges::count_if(
        taps_, [&](const Tap& tap) { return tap.key == key && (repeats || !tap.is_repeat); }));
}

namespace {

std::vector<std::filesystem::path> dropped;  // GLFW's events come on the main thread alone

}  // namespace

void remember_dropped_files(GLFWwindow* window) {
    glfwSetDropCallback(window, [](GLFWwindow*, int count, const char** files) {
        for (int i = 0; i < count; ++i) dropped.emplace_back(files[i]);
    });
}

std::vector<std::filesystem::path> take_dropped_files() {
    return std::exchange(dropped, {});
}

FileKind kind_of(const std::filesystem::path& file) {
    std::string end = file.extension().string();
    std::ranges::transform(end, end.begin(),
                           [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    if (end == ".json") return FileKind::settings;
    if (end == ".obj") return FileKind::garment;
    if (end == ".gltf" || end == ".glb") return has_skin(file) ? FileKind::character : FileKind::garment;
    return FileKind::unknown;
}

}  // namespace weft::demo
