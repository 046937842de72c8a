#pragma once
// The state of a seam.

#include <array>
#include <cstdint>
#include <vector>

#include "weft/seam.h"

namespace weft {

/// The particles that a stitch joins: one of the seam's first cloth, one of its second.
struct Stitch {
    std::array<std::uint32_t, 2> particles;
};

struct SeamState {
    SeamSettings settings;
    std::array<ClothId, 2> cloths;
    std::vector<Stitch> stitches;
    std::vector<std::uint32_t> holds;  ///< by stitch: 1, or 0 once it has broken
};

}  // namespace weft
