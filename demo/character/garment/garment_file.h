#pragma once
// Garments from Wavefront OBJ files, and the materials that say what of them is simulated.

#include <filesystem>

#include "demo/character/garment/garment.h"
#include "weft/error.h"

namespace weft::demo {

/// Where a file has materials (`usemtl`), vertices of faces whose material's name ends in "Free" are
/// simulated, all others are fixed to the body; the garment is +Y up and stands round the body's stance. A
/// file without any is +Z up, stands anywhere, and is held by its highest opening: round the waist if it has
/// one other, else about the neck.
///
/// The names alone decide. From the file that `mtllib` names come colours (Kd of the first Free material);
/// where it is missing, or lacks a material, the garment has its default colour and a note says so. Texture
/// coordinates in metres are the flat pattern.
/// Beside it there may be maps (painted_maps.h).
///
/// Errors: load_obj's; read_maps'; materials none of which ends in "Free"; a garment less than 0.1 m or more
/// than 3 m high, or wide, for which nobody here is the right size.
[[nodiscard]] Result<Garment> read_garment(const std::filesystem::path& file);

}  // namespace weft::demo
