#pragma once
// Seams: stitches that join vertices of one cloth, or of two. See World::stitch().

#include <cstdint>
#include <limits>

#include "weft/cloth_id.h"
#include "weft/types.h"

namespace weft {

/// Identifies a seam in a World. Generation-checked; all-zero is null.
struct SeamId {
    std::uint32_t index = 0, generation = 0;
    friend bool operator==(SeamId, SeamId) = default;
};

/// Settings of a seam, the same for each of its stitches.
struct SeamSettings {
    /// Distance at which a stitch holds its two vertices [m], 0 to 10: the length of a button's thread. 0:
    /// they are drawn together. Where the two cloths meet by SelfCollisionMethod::contact, the mean of their
    /// SelfCollision::distance is the least that counts: cloth is as thick as that.
    float rest_length = 0;
    /// Tension at which a stitch breaks, for good [N], above 0; infinity, the default: never.
    float break_force = std::numeric_limits<float>::infinity();
    /// Force of a stitch over its extension [N/m], 1e-3 to 1e7; 0, the default: the greatest Fabric::warp or
    /// weft of its cloths, at least 1: a stitch gives as much as a cell of the fabric beside it. By stiffer
    /// stitches motion passes more slowly from cloth to cloth, unless Multilevel::passes are raised as well.
    float stiffness = 0;
};

/// A seam as it is now, and what it bore in the last step.
struct SeamInfo {
    ClothId a{}, b{};            ///< its cloths; the same twice, if it joins vertices of one
    std::uint32_t stitches = 0;  ///< all of them
    std::uint32_t holding = 0;   ///< those that have not broken
    /// Force on `a`, of all stitches, in the last substep [N]; 0 before the first step and after restore().
    Vec3 force{};
    /// Tension of the tightest stitch in the last substep [N], of those that broke in it, too.
    float tightest = 0;
};

}  // namespace weft
