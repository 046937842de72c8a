#pragma once
// The state hashes that were recorded for the demo's scenes, and for what.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace weft::demo {

/// A text file: lines "compiler NAME", "targets NAMES", and "SCENE HASH" for each scene; # begins a comment.
struct GoldenHashes {
    std::string compiler;              ///< and what else of the build the bytes depend on
    std::vector<std::string> targets;  ///< Highway's, all of which gave these hashes
    std::map<std::string, std::string> of_scene;

    /// Empty where there is no file.
    [[nodiscard]] static GoldenHashes read(const std::filesystem::path& file);
    /// False: it cannot be written.
    [[nodiscard]] bool write(const std::filesystem::path& file) const;
};

}  // namespace weft::demo
