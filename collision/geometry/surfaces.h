#pragma once
// How the properties of two surfaces that meet combine, whether cloth, colliders or bodies. weft/collider.h
// states the rule for users.

#include <algorithm>
#include <cmath>

namespace weft {

/// Coulomb coefficient between two surfaces that have one each: the geometric mean. Two equal ones keep
/// theirs, and a smooth one is smooth against any other.
[[nodiscard]] inline float friction_between(float a, float b) {
    return std::sqrt(a * b);
}
/// Distance between two surfaces of which each keeps its own [m].
[[nodiscard]] inline float thickness_between(float a, float b) {
    return a + b;
}
/// Coefficient of restitution: the greater, so that a ball bounces off anything.
[[nodiscard]] inline float restitution_between(float a, float b) {
    return std::max(a, b);
}

}  // namespace weft
