#pragma once
// Bending as a linear force. The energy of an element is quadratic in positions,
//
//     E = 1/2 B k |sum_a c_a x_a|^2,   sum_a c_a = 0,
//
// for B the flexural rigidity. So its Hessian is constant, and between two particles a number times the
// identity: w_ij = -B k c_i c_j.

#include <array>
#include <cstdint>
#include <vector>

#include "cloth/mesh/cook.h"
#include "cloth/mesh/rest/vertex_bending.h"

namespace weft {

struct BendingElement {
    std::array<std::uint32_t, 4> particles;  ///< an element of three particles repeats its first
    std::array<float, 4> c;                  ///< [1/m]; sum 0
    float k;                                 ///< [m^0]; k c^2 is in 1/m^2
};

/// A sheet's elements: the bending of threads, by the second difference of three particles, and the twist of
/// cells, by that of their four corners. Together they are the plate's B/2 |curvature tensor|^2 with
/// Poisson's ratio 0. A general mesh has one element per pair of triangles that share an edge (Bergou et al.
/// 2006), for methods whose elements have four particles. The others use vertex_bending().
/// Precondition: the model has springs and triangles.
[[nodiscard]] std::vector<BendingElement> linear_bending(const ClothModel& model);

/// Sums the elements up in the model: ClothModel::bending and bending_excess. Precondition: the model has a
/// half-edge between any two particles that bending joins.
void store_bending(const std::vector<BendingElement>& elements, ClothModel& model);

void store_bending(const VertexBending& bending, ClothModel& model);

/// The greatest sum of the magnitudes of a particle's weights over its rest area [1/m^4].
[[nodiscard]] float find_bending_per_area(const ClothModel& model);

}  // namespace weft
