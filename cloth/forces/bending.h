#pragma once
// Bending of two triangles about their shared edge, by a flexural rigidity B [N m]. Both models have the
// energy B/2 l^2/A theta^2 per hinge while angles are small, l being the edge's length and A the area of both
// triangles.
//
// With that coefficient regular meshes, of right or of equilateral triangles, bend to any cylinder at the
// plate's energy B/2 kappa^2 per area (Seung and Nelson 1988 for the latter, as k = 2 B / sqrt 3). The 3
// l^2/A of Grinspun et al. 2003 and Bergou et al. 2006, which give an edge a third of its triangles for its
// own, is three times as stiff: they leave the scale to the user.

#include <array>

#include "cloth/forces/rest_elements.h"
#include "engine/vector.h"

namespace weft {

/// Quadratic bending (Bergou et al. 2006), B/2 |sum_k q_k x_k|^2 / A. It rests flat, does not feel rigid
/// motions, and its Hessian is constant: q_a q_b times this [1/m^2] for rigidity 1.
[[nodiscard]] inline float quadratic_bending(const Hinge& hinge) {
    return 1.0f / hinge.area;
}

/// Dihedral bending (Bridson et al. 2003, Grinspun et al. 2003), k/2 (theta - rest angle)^2, for rigidity 1.
[[nodiscard]] inline float dihedral_bending(const Hinge& hinge) {
    return hinge.length * hinge.length / hinge.area;
}

/// The angle between the normals of triangles (0, 1, 2) and (1, 0, 3), positive where the fronts face each
/// other less, and its exact gradient; both by Tamstorf and Grinspun 2013.
struct Dihedral {
    float angle;
    std::array<Vector3, 4> gradient;
};

/// `least_height` > 0 bounds the gradient of triangles that have collapsed to a line: heights below count as
/// it [m].
[[nodiscard]] Dihedral dihedral(const std::array<Vector3, 4>& x, float least_height);

}  // namespace weft
