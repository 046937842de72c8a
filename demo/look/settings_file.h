#pragma once
// Settings as a JSON file:
//
//     {"scene": "flag",
//      "wind": {"velocity": [6, 0, 1], "gusts": 0.5, "swirl_size": 0.8},
//      "substeps": 4, "budget": 0,
//      "material": {"areal_density": 0.12, "warp": 400, "weft": 400, "shear": 100, "bending": 5e-6,
//                   "damping": 2e-4, "stiffening": 0, "bending_ratio": 1},
//      "method": "multilevel", "iterations": 3, "cloth_substeps": 1,
//      "self_collision": "avoidance", "layers_apart": 0, "air_drag": 0.2, "gap_to_bodies": 0.005,
//      "friction": 1, "back_friction_ratio": 1}
//
// Besides, each number of Wind, of WorldSettings but for threads and contact reports, and of ClothSettings is
// there by its name. Units are metres, seconds and kilograms. A key that is left out changes nothing;
// "iterations" are the passes of the method multilevel.

#include <filesystem>
#include <string>

#include "demo/look/settings_values.h"
#include "demo/scene_simulation.h"

namespace weft::demo {

/// Error: the file cannot be written.
[[nodiscard]] Result<void> save_settings(const std::filesystem::path& file, const Simulation& simulation);

/// Applies the file to the world and all cloths; with an error nothing changes. Errors name the file and the
/// key, and say which values are valid.
[[nodiscard]] Result<void> load_settings(const std::filesystem::path& file, Simulation& simulation);

}  // namespace weft::demo
