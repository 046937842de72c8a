#pragma once
// Files that somebody drops on the window.

#include <filesystem>
#include <vector>

struct GLFWwindow;

namespace weft::demo {

/// Begins to remember files that are dropped on the window.
void remember_dropped_files(GLFWwindow* window);
/// The files dropped since the last call.
[[nodiscard]] std::vector<std::filesystem::path> take_dropped_files();

/// The kind of a file, by its extension. A glTF file with a skin is a character, else a garment.
enum class FileKind { settings, garment, character, unknown };
[[nodiscard]] FileKind kind_of(const std::filesystem::path& file);

}  // namespace weft::demo
