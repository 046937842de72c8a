#pragma once
// Boxes along the axes.

#include "engine/vector.h"
#include "weft/types.h"

namespace weft {

inline Bounds grown(const Bounds& box, float by) {
    const Vector3 margin = Vector3::Constant(by);
    return {to_vec3(to_vector(box.lower) - margin), to_vec3(to_vector(box.upper) + margin)};
}

[[nodiscard]] inline bool overlap(const Bounds& a, const Bounds& b) {
    return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y &&
           b.lower.y <= a.upper.y && a.lower.z <= b.upper.z && b.lower.z <= a.upper.z;
}

}  // namespace weft
