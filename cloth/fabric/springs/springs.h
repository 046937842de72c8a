#pragma once
// Springs: their forces, and the derivatives of the forces.

#include <cmath>
#include <cstdint>

#include "engine/separating_direction.h"
#include "engine/vector.h"
#include "weft/settings.h"

namespace weft {

/// A spring's force on its first particle and the stiffness blocks K = a I + b n n^T = -dforce_i/dx_i =
/// dforce_i/dx_j.
struct SpringTerms {
    Vector3 force;      ///< [N], on particle i
    Vector3 direction;  ///< n, from i to j
    float isotropic;    ///< a [N/m]
    float axial;        ///< b [N/m]
};

/// The spring from particle i to particle j, which is at `separation` from it. Both ends compute the same
/// floats with opposite signs, so that momentum is kept to the last bit.
///
/// Kang, section III: K = k [(1 - L/l)(I - n n^T) + n n^T], whose first term turns negative, and unbounded as
/// l -> 0, in compression; there the derivative (not the force) takes L := l, which leaves k n n^T.
[[nodiscard]] inline SpringTerms spring_terms(const Vector3& separation, float rest_length, float stiffness,
                                              std::uint32_t i, std::uint32_t j) {
    const float squared = separation.squaredNorm();
    const float length = std::sqrt(squared);
    const float inverse_length = 1.0f / length;
    const bool has_direction = squared > 1e-24f;
    const Vector3 n = has_direction ? Vector3(separation * inverse_length) : separating_direction(j, i);
    const float isotropic = length > rest_length ? stiffness * (1.0f - rest_length * inverse_length) : 0.0f;
    return {.force = stiffness * (length - rest_length) * n,
            .direction = n,
            .isotropic = isotropic,
            .axial = stiffness - isotropic};
}

}  // namespace weft
