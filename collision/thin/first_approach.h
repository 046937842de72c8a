#pragma once
// Continuous collision: where a moving triangle first comes near a core.

#include <array>
#include <optional>

#include "collision/thin/cores.h"
#include "engine/vector.h"

namespace weft {

/// Straight paths of a triangle's corners, or of an edge's two, in the cores' local frame.
struct CornerPaths {
    std::array<Vector3, 3> from, to;  // [m]
};

/// An approach that has to be stopped.
struct Approach {
    std::array<float, 3> weights;  ///< barycentric weights of the point that comes near
    Vector3 core;                  ///< the core's nearest point, local [m]
    Vector3 normal;                ///< local, of unit length, towards the triangle
    float depth;                   ///< the gap less the distance at the end, along the normal [m]
};

struct Kept {
    float gap;  ///< distance to keep from the core's balls [m]
    /// An edge that begins within a segment's balls is ignored. Particles let out a limb that is thicker than
    /// cells; holding the edge would keep the limb in.
    bool only_from_outside = false;
};

/// Conservative advancement (Mirtich 1996) of an edge against a segment core, or of a triangle against a
/// point core. Nothing if the path stays on its side of the plane in which the two first come near, or begins
/// inside.
[[nodiscard]] std::optional<Approach> first_approach(const Cores& cores, const Core& core,
                                                     const CornerPaths& paths, const Kept& kept);

}  // namespace weft
