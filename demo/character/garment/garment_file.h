#pragma once
// Garments from Wavefront OBJ files, whose materials decide which vertices are simulated.

#include <filesystem>

#include "demo/character/garment/garment.h"
#include "weft/error.h"

namespace weft::demo {

/// Vertices of faces whose material's name (`usemtl`) ends in "Free" are simulated, all others are fixed to
/// the body. Such a garment is +Y up and stands round the body's stance. A file without such a material is +Z
/// up, or +Y up if `y_is_up`, and stands anywhere. The body holds it by its highest opening: round the waist
/// if it has one other opening, otherwise about the neck.
///
/// The names alone decide what is simulated. The file that `mtllib` names gives each material's colour (Kd)
/// and picture (map_Kd). Where it or a material is missing, the default colour is taken and a note says so.
/// Texture coordinates in metres are the flat pattern. Maps may stand beside the file (painted_maps.h).
///
/// `unit`: metres in a unit of the file; 0: a garment's size decides. Errors: load_obj's; read_maps'; a
/// garment whose longest side is above 3 m or below 0.1 m.
[[nodiscard]] Result<Garment> read_garment(const std::filesystem::path& file, float unit = 1,
                                           bool y_is_up = false);

}  // namespace weft::demo
