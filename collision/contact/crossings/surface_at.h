#pragma once
// Normal and neighbourhood of a body's surface at one of its particles.

#include <cstdint>
#include <span>

#include "collision/contact/pairs/pair_finder.h"
#include "engine/vector.h"
#include "weft/types.h"

namespace weft {

struct SurfaceAt {
    Vector3 normal = Vector3::Zero();  ///< sum of twice the area vectors of the particle's triangles [m^2]
    float area = 0;                    ///< sum of the lengths of these vectors [m^2]
    Vector3 ring = Vector3::Zero();    ///< from the particle to the mean of its triangles' other corners [m]
    float length = 0;                  ///< mean distance to these corners [m]
};

/// `particle` is numbered through all bodies, as are `positions`.
[[nodiscard]] inline SurfaceAt surface_at(const ContactBody& body, std::span<const Vec4> positions,
                                          std::uint32_t particle) {
    SurfaceAt at;
    const Vector3 here = xyz(positions[particle]);
    const std::span<const std::uint32_t> triangles = body.mesh->triangles_of(particle - body.first);
    for (const std::uint32_t t : triangles) {
        const ContactMesh::Triangle& corners = body.mesh->triangles()[t];
        Vector3 from_here[3];
        for (std::uint32_t c = 0; c < 3; ++c) {
            from_here[c] = xyz(positions[body.first + corners[c]]) - here;
            at.ring += from_here[c];
            at.length += from_here[c].norm();
        }
        const Vector3 area = (from_here[1] - from_here[0]).cross(from_here[2] - from_here[0]);
        at.normal += area;
        at.area += area.norm();
    }
    if (const auto others = static_cast<float>(2 * triangles.size()); others > 0) {
        at.ring /= others;
        at.length /= others;
    }
    return at;
}

}  // namespace weft
