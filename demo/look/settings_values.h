#pragma once
// Writes and reads the text of a file of settings (settings_file.h).

#include <filesystem>
#include <string>

#include "weft/weft.h"

namespace weft::demo {

struct SettingsValues {
    WorldSettings world;
    ClothSettings cloth;
};

[[nodiscard]] std::string settings_text(const std::string& scene, const SettingsValues& present);

/// The given settings, replaced by the file's where it names them. Errors name the file and the key, and say
/// which values are valid.
[[nodiscard]] Result<SettingsValues> read_settings(const std::filesystem::path& file,
                                                   const WorldSettings& world, const ClothSettings& cloth);

/// The scene that a file of settings names; "" if none. Errors: no readable JSON object; the scene is no
/// string.
[[nodiscard]] Result<std::string> scene_of_settings(const std::filesystem::path& file);

}  // namespace weft::demo
