#pragma once
// Files that somebody drops on the window.

#include <filesystem>
#include <vector>

struct GLFWwindow;

namespace weft::demo {

/// From here on they are remembered.
void remember_dropped_files(GLFWwindow* window);
/// Those since the last call.
[[nodiscard]] std::vector<std::filesystem::path> take_dropped_files();

/// What a file is, by the end of its name; a glTF file by whether anybody is in it.
enum class FileKind { settings, garment, character, unknown };
[[nodiscard]] FileKind kind_of(const std::filesystem::path& file);

}  // namespace weft::demo
