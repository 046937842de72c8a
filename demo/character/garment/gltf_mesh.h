#pragma once
// Triangles from a glTF 2.0 file, as cloth.

#include <filesystem>

#include "weft/error.h"
#include "weft/mesh.h"

namespace weft::demo {

/// Whether the file's name ends in .gltf or .glb.
[[nodiscard]] bool is_gltf(const std::filesystem::path& file);

/// Whether a glTF file has a skin with joints: somebody who wears something. False where it cannot be read.
[[nodiscard]] bool has_skin(const std::filesystem::path& file);

/// All triangles of .gltf or .glb, where its nodes and skins put them, +Y up [m]. Errors name the file and
/// what it lacks: triangles in a node's mesh, positions; and a primitive that is faulty.
[[nodiscard]] Result<Mesh> read_gltf_mesh(const std::filesystem::path& file);

}  // namespace weft::demo
