#pragma once
// A skinned character from a glTF 2.0 file: skeleton, motion, and a garment with weights.

#include <filesystem>
#include <vector>

#include "demo/character/garment/garment.h"
#include "demo/character/motion/bvh.h"
#include "weft/error.h"

namespace weft::demo {

/// Joints and weights: four of both a vertex.
struct SkinnedMesh {
    Mesh mesh;  ///< as it is at rest
    std::vector<std::uint32_t> joints;
    std::vector<float> weights;
    std::vector<Vec3> colours;  ///< by vertex, or none
};

struct SkinnedCharacter {
    /// Of the file's first animation, 60 frames a second; of one frame, the pose in which nodes are, where
    /// there is none. Joints at rest stand as the file's nodes do.
    Recording recording;
    JointAngles rest;
    /// All of the skin's triangles whose material ends in "Free", and those of the materials that share
    /// vertices with them; as they are at rest.
    Garment garment;
    std::vector<std::uint32_t> joints;  ///< four a vertex of the garment
    std::vector<float> weights;         ///< likewise
    SkinnedMesh body;                   ///< all other triangles of the skin, where they are asked for
};

/// Reads .gltf and .glb: the first skin, and of the meshes that have it the primitives of materials whose
/// name ends in "Free" or begins with "Garment"; vertices of the first are simulated, the others fixed by
/// their weights. Scales of nodes count, sheared axes do not. Errors name the file and what it lacks: a skin,
/// joints, a primitive of a Free material, positions, joints or weights, four of both a vertex; triangles of
/// a body, where it is asked for. Beside it there may be maps (painted_maps.h).
[[nodiscard]] Result<SkinnedCharacter> read_gltf(const std::filesystem::path& file, bool with_body = false);

}  // namespace weft::demo
