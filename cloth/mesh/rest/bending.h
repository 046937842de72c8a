#pragma once
// Bending by a flexural rigidity B [N m], of the energy that rest_elements.h states.
//
// Quadratic bending (Bergou et al. 2006): phi_e = sum_k q_k x_k, a vector. Its rest shape is flat. Its
// Hessian is constant and, since it is the same for x, y and z, has one number per pair of particles. Rigid
// motions cost nothing. The 3/(A + A') of that paper, by which an edge owns a third of its triangles, is
// three times as stiff as the plate; they leave the scale to the user.
//
// Dihedral bending (Bridson et al. 2003, Grinspun et al. 2003): phi_e = length (angle - angle at rest), exact
// for large angles.

#include <array>
#include <functional>

#include "cloth/mesh/rest/rest_elements.h"
#include "engine/vector.h"

namespace weft {

/// Calls body(i, j, k) for the terms k [1/m^2] of particles i != j in the Hessian of quadratic bending with
/// rigidity 1. Each pair occurs in both orders, and once for each element that has it: sum the terms.
void for_each_quadratic_term(const Bending& bending,
                             const std::function<void(std::uint32_t, std::uint32_t, float)>& body);

/// The angle between the normals of triangles (0, 1, 2) and (1, 0, 3), positive where their fronts face away
/// from each other, and its gradient (Tamstorf and Grinspun 2013). The gradient of triangles that have
/// collapsed is bounded: heights below `least_height` count as it [m].
struct Dihedral {
    float angle;
    std::array<Vector3, 4> gradient;
};
[[nodiscard]] Dihedral dihedral(const std::array<Vector3, 4>& x, float least_height);

}  // namespace weft
