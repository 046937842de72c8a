#pragma once
// A skinned character from a glTF 2.0 file (skeleton, motion, and a garment with weights), or its triangles
// as cloth.

#include <filesystem>
#include <vector>

#include "demo/character/garment/garment.h"
#include "demo/character/motion/motion.h"
#include "weft/error.h"
#include "weft/mesh.h"

namespace weft::demo {

/// A mesh with joints and weights, `influences` of both a vertex.
struct SkinnedMesh {
    Mesh mesh;                   ///< in the rest pose
    std::size_t influences = 0;  ///< the most that a part of the file has
    std::vector<std::uint32_t> joints;
    std::vector<float> weights;
    std::vector<Vec3> colours;  ///< one a vertex, or none
};

struct SkinnedCharacter {
    /// The file's first animation at 60 frames a second; without an animation, one frame of the nodes' own
    /// pose. The rest pose of joints is that of the file's nodes.
    Recording recording;
    JointAngles rest;
    Garment garment;   ///< of the worn triangles
    SkinnedMesh worn;  ///< the worn triangles of all skins, in the rest pose
    SkinnedMesh body;  ///< all other triangles of the skins; empty unless asked for
};

/// Reads .gltf and .glb (weft/gltf.h): all skins as one person's, and of their meshes the primitives that are
/// worn. Those of a material whose name ends in "Free" are simulated. Those of a material whose name begins
/// with "Garment", and all that share the place of a vertex with something worn, are fixed by their weights.
/// All others are of the body; notes of the garment name them, and those that
/// are faulty and left out. Maps may stand beside the file
/// (painted_maps.h). Errors name the file and what it lacks: GltfAsset::load()'s; a skin, joints, a primitive
/// of a Free material; triangles of a body, where it is asked for. A faulty primitive is an error where it is
/// worn, or of the body that is asked for.
[[nodiscard]] Result<SkinnedCharacter> read_gltf(const std::filesystem::path& file, bool with_body = false);

/// True if the file's name ends in .gltf or .glb.
[[nodiscard]] bool is_gltf(const std::filesystem::path& file);

/// True if a glTF file has a skin with joints: somebody who wears something. False where it cannot be read.
[[nodiscard]] bool has_skin(const std::filesystem::path& file);

/// Colours and pictures of a glTF file's materials, and what is missing of them.
struct GltfSurface {
    SurfaceParts parts;
    std::vector<std::string> notes;
};

/// All triangles of .gltf or .glb, where its nodes and skins put them, +Y up [m]; texture coordinates run
/// upwards, as everywhere but in the file. Errors name the file and what it lacks: triangles in a node's
/// mesh, positions; and a primitive that is faulty. `surface` may be null.
[[nodiscard]] Result<Mesh> read_gltf_mesh(const std::filesystem::path& file, GltfSurface* surface = nullptr);

}  // namespace weft::demo
