#pragma once
// The study's scenes. Every run of a scene, by any method, starts from the same floats.

#include <filesystem>
#include <string>

#include "demo/study/run.h"

namespace weft::study {

/// A sheet of 1 m and 0.2 kg/m^2 hung by two corners of one side, horizontal but for a bump of 0.1 mm that
/// has no symmetry, so that the scene and not rounding decides how the sheet buckles. `wind`: in a steady
/// breeze; otherwise in still air that takes 0.2 of the velocity per second.
[[nodiscard]] StudyScene hung_sheet(std::uint32_t per_side, bool wind);

/// A garment of a file, hung by its highest opening in still air.
[[nodiscard]] StudyScene hung_garment(const std::filesystem::path& obj, const std::string& name);

}  // namespace weft::study
