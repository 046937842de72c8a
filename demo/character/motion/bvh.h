#pragma once
// Recorded motion from files in Biovision's format (BVH).

#include <filesystem>
#include <vector>

#include "demo/character/motion/skeleton.h"
#include "weft/error.h"

namespace weft::demo {

/// One pose for each frame.
struct Recording {
    Skeleton skeleton;
    double frame_time = 1.0 / 60;  ///< [s]
    std::vector<JointAngles> frames;
};

/// Reads hierarchy and motion: any number of channels in any order, rotations in the order in which the file
/// names them, lengths in metres. Lengths that would make somebody of more than ten metres are taken for
/// centimetres. Position channels of other joints than the root are ignored: bones keep their lengths.
/// Errors name the file, the line and the value: a file that cannot be read or ends too soon, another word
/// than must stand there, a number that is none or not finite, joints or frames too many (1024; 10^6; 2^25
/// their product), a bone or a place of the root of more than 10^5 m.
[[nodiscard]] Result<Recording> read_bvh(const std::filesystem::path& file);

}  // namespace weft::demo
