#pragma once
// The materials of an OBJ file's faces, and their colours and pictures in its MTL file.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "demo/character/garment/surface_parts.h"
#include "weft/error.h"
#include "weft/types.h"

namespace weft::demo {

/// The materials (`usemtl`) of an OBJ file, and what has them. Those whose name ends in "Free" are simulated.
struct ObjMaterials {
    std::vector<std::string> names;     ///< in order of use; empty: the file has none
    std::vector<bool> used, simulated;  ///< by `v` line: some face has the vertex, some simulated one has
    std::vector<std::uint32_t> of_triangle;  ///< 0: none yet; k + 1: names[k]; one per triangle of load_obj
    std::string library;                     ///< as `mtllib` names it
    std::size_t vertices = 0;                ///< `v` lines
};

/// Precondition: load_obj has read the file. Error: a statement that is too long.
[[nodiscard]] Result<ObjMaterials> read_obj_materials(const std::filesystem::path& obj);

/// The diffuse colours (Kd) and pictures (map_Kd) of the materials, from the MTL file that `obj` names. Where
/// one is missing its faces have `default_colour`, and `notes` say so. Without an MTL file there are no
/// parts.
[[nodiscard]] SurfaceParts read_mtl(const std::filesystem::path& obj, const ObjMaterials& materials,
                                    const Vec3& default_colour, std::vector<std::string>& notes);

[[nodiscard]] inline bool is_simulated(std::string_view material) {
    return material.ends_with("Free");
}

}  // namespace weft::demo
