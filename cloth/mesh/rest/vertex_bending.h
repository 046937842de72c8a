#pragma once
// Linear bending of general meshes, by vertices.
//
// Hinges by themselves are not the plate on an irregular mesh, whatever their weights: a constant moment M is
// in equilibrium there if the hinge at edge e bears n . M n, n being the edge's normal (Hellan 1967, Herrmann
// 1967, Johnson 1973; Morley 1968). With n n^T of each edge shared between the vertices at its ends, n n^T =
// p_a + p_b, the energy of vertex v is
//
//     E_v = 1/2 B |A_v^-1/2 sum_e p_e phi_e|^2,   A_v = sum_e f_e p_e^T,
//
// phi_e being the hinge's sum_k q_k x_k and f_e : K its value on a sheet of curvature K; tensors are vectors
// (xx, yy, sqrt 2 xy). If A_v is symmetric, a sheet of any constant curvature has the plate's energy and no
// force inside. Equal halves do not make A_v symmetric. The exchange between the ends of edges that does
// is found here. E_v is up to three squares |sum_i c_i x_i|^2 over the vertex and its neighbours.
//
// Cloth whose rigidity B D is not the same in all directions is reduced to this by taking D^1/2 K for the
// curvature and D^-1/2 M for the moment: n n^T and f then stand for D^1/2 n n^T and D^-1/2 f.

#include <cstdint>
#include <vector>

#include "cloth/mesh/cook.h"

namespace weft {

/// A pair of particles i < j that bending of rigidity 1 joins; the weight is ClothModel::bending's [1/m^2].
struct BendingPair {
    std::uint32_t i, j;
    double weight;
    double length;  ///< their distance where the cloth lies flat [m]
};
struct VertexBending {
    std::vector<BendingPair> pairs;  ///< ascending, each once
    std::vector<double> excess;      ///< ClothModel::bending_excess
    std::uint32_t elements = 0;
};
/// Computes the bending of a general mesh from its triangles and rest shape; the model needs no springs yet.
/// A border bears no moment about itself, and a border's corner bears twist alone. Hinges of slivers are
/// softened, see sliver_factor().
[[nodiscard]] VertexBending vertex_bending(const ClothModel& model);

}  // namespace weft
