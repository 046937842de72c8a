#include "demo/look/dropped.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>

#include "demo/character/garment/gltf_mesh.h"

namespace weft::demo {
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
