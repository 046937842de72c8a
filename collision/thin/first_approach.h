#pragma once
// Where a triangle on its way first comes near a core.

#include <array>
#include <optional>

#include "collision/thin/cores.h"
#include "engine/vector.h"

namespace weft {

/// Corners of a triangle, or of an edge, which has two, in the cores' space; they go straight.
struct CornerPaths {
    std::array<Vector3, 3> from, to;  // [m]
};

/// What is not to go on as it does.
struct Approach {
    std::array<float, 3> weights;  ///< of the corners: the point that comes near
    Vector3 core;                  ///< the point that it comes near to, own [m]
    Vector3 normal;                ///< own, of unit length, towards the triangle
    float depth;                   ///< what is missing of the gap at the end, along the normal [m]
};

struct Kept {
    float gap;  ///< from the core's balls [m]
    /// An edge that begins within a segment's balls is let be: where a limb is thicker than cells particles
    /// let it out, and to hold it would keep it in.
    bool only_from_outside = false;
};

/// Conservative advancement (Mirtich 1996): of an edge against a core that is a segment, or of a triangle
/// against one that is a point. Nothing where the path keeps to its side of the plane in which the two first
/// come near, or begins within.
[[nodiscard]] std::optional<Approach> first_approach(const Cores& cores, const Core& core,
                                                     const CornerPaths& paths, const Kept& kept);

}  // namespace weft
