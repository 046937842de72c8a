#pragma once
// The point of a triangle that is nearest to a given point.

#include <algorithm>
#include <array>

#include "engine/vector.h"

namespace weft {

/// Barycentric weights of the nearest point; none is 0 only if it lies within the face. A triangle without
/// area counts as its first corner, or its sides. C. Ericson, "Real-time collision detection", 2004, 5.1.5.
inline std::array<float, 3> nearest_on_triangle(const Vector3& p, const std::array<Vector3, 3>& x) {
    const auto part = [](float of, float all) { return all > 0 ? std::clamp(of / all, 0.0f, 1.0f) : 0.0f; };
    const Vector3 ab = x[1] - x[0], ac = x[2] - x[0], ap = p - x[0], bp = p - x[1], cp = p - x[2];
    const float d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
    const float d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
    const float vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        const float second = part(d1, d1 - d3);
        return {1 - second, second, 0};
    }
    const float d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
    const float vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        const float third = part(d2, d2 - d6);
        return {1 - third, 0, third};
    }
    const float va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const float third = part(d4 - d3, (d4 - d3) + (d5 - d6));
        return {0, 1 - third, third};
    }
    const float sum = va + vb + vc;
    if (!(sum > 0)) return {1, 0, 0};
    return {va / sum, vb / sum, vc / sum};
}

}  // namespace weft
