#pragma once
// The text of a file of settings, and what it sets (settings_file.h).

#include <filesystem>
#include <string>

#include "weft/weft.h"

namespace weft::demo {

struct SettingsValues {
    WorldSettings world;
    ClothSettings cloth;
};

[[nodiscard]] std::string settings_text(const std::string& scene, const SettingsValues& present);

/// The settings with what the file names in their place. Errors name the file and the key, and say what would
/// be right.
[[nodiscard]] Result<SettingsValues> read_settings(const std::filesystem::path& file,
                                                   const WorldSettings& world, const ClothSettings& cloth);

/// The scene that a file of settings names; "" if none. Errors: it cannot be read, or is no JSON object.
[[nodiscard]] Result<std::string> scene_of_settings(const std::filesystem::path& file);

}  // namespace weft::demo
