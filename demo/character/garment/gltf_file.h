#pragma once
// A skinned character from a glTF 2.0 file: skeleton, motion, and a garment with weights.

#include <filesystem>
#include <vector>

#include "demo/character/garment/garment.h"
#include "demo/character/motion/bvh.h"
#include "weft/error.h"

namespace weft::demo {

/// A mesh with four joints and four weights a vertex.
struct SkinnedMesh {
    Mesh mesh;  ///< in the rest pose
    std::vector<std::uint32_t> joints;
    std::vector<float> weights;
    std::vector<Vec3> colours;  ///< one a vertex, or none
};

struct SkinnedCharacter {
    /// The file's first animation at 60 frames a second; without an animation, one frame of the nodes' own
    /// pose. The rest pose of joints is that of the file's nodes.
    Recording recording;
    JointAngles rest;
    /// The worn triangles of the skin, in the rest pose.
    Garment garment;
    std::vector<std::uint32_t> joints;  ///< four a vertex of the garment
    std::vector<float> weights;         ///< four a vertex of the garment
    SkinnedMesh body;                   ///< all other triangles of the skin; empty unless asked for
};

/// Reads .gltf and .glb: the first skin, and of its meshes the primitives that are worn. Those of a material
/// whose name ends in "Free" are simulated. Those of a material whose name begins with "Garment", and all
/// that share the place of a vertex with something worn, are fixed by their weights. All others are of the
/// body; notes of the garment name them. Scales of nodes apply, shear is ignored. Maps may stand beside the
/// file (painted_maps.h). Errors name the file and what it lacks: a skin, joints, a primitive of a Free
/// material, positions, joints or weights, four of both a vertex; triangles of a body, where it is asked for.
[[nodiscard]] Result<SkinnedCharacter> read_gltf(const std::filesystem::path& file, bool with_body = false);

}  // namespace weft::demo
