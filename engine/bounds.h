#pragma once
// Axis-aligned bounding boxes.

#include <limits>

#include "engine/vector.h"
#include "weft/types.h"

namespace weft {

inline constexpr Bounds everywhere = [] {
    constexpr float endless = std::numeric_limits<float>::infinity();
    return Bounds{{-endless, -endless, -endless}, {endless, endless, endless}};
}();

inline Bounds grown(const Bounds& box, float by) {
    const Vector3 margin = Vector3::Constant(by);
    return {to_vec3(to_vector(box.lower) - margin), to_vec3(to_vector(box.upper) + margin)};
}

[[nodiscard]] inline bool overlap(const Bounds& a, const Bounds& b) {
    return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y &&
           b.lower.y <= a.upper.y && a.lower.z <= b.upper.z && b.lower.z <= a.upper.z;
}

/// Two boxes are apart if no point is in both. A box with a coordinate that is not a number is apart from
/// none along that axis.
[[nodiscard]] inline bool are_apart(const Bounds& a, const Bounds& b) {
    return a.lower.x > b.upper.x || b.lower.x > a.upper.x || a.lower.y > b.upper.y || b.lower.y > a.upper.y ||
           a.lower.z > b.upper.z || b.lower.z > a.upper.z;
}

}  // namespace weft
