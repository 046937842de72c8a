#pragma once
// A skinned character from a glTF 2.0 file: skeleton, motion, and a garment with weights.

#include <filesystem>
#include <vector>

#include "demo/character/garment/garment.h"
#include "demo/character/motion/bvh.h"
#include "weft/error.h"

namespace weft::demo {

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
};

/// Reads .gltf and .glb: the first skin, and of the meshes that have it the primitives of materials whose
/// name ends in "Free" or begins with "Garment"; vertices of the first are simulated, the others fixed by
/// their weights. Scales of nodes count, sheared axes do not. Errors name the file and what it lacks: a skin,
/// joints, a primitive of a Free material, positions, joints or weights, four of both a vertex.
[[nodiscard]] Result<SkinnedCharacter> read_gltf(const std::filesystem::path& file);

}  // namespace weft::demo
