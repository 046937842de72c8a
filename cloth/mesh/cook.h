#pragma once
// Cooking: the data that is computed once from a mesh, and read by every step.

#include <array>
#include <cstdint>
#include <vector>

#include "cloth/mesh/progress.h"
#include "engine/memory/shared_buffer.h"
#include "weft/cooked_cloth.h"
#include "weft/error.h"
#include "weft/mesh.h"

namespace weft {

/// The link of two particles: a spring along an edge or thread, a spring across a grid's cell, or bending
/// alone.
enum class SpringKind : std::uint8_t { structural, shear, bending };

constexpr float least_bending_ratio = 0.01f, greatest_bending_ratio = 100;

/// The rest model of a cloth, which copies share. It never changes after cooking, except by maps. Lists are
/// in compressed rows: those of particle i are [offsets[i], offsets[i + 1]). Rows ascend by the indices that
/// they hold, and are summed in this order.
struct ClothModel {
    std::uint32_t particle_count = 0;
    std::uint32_t rows = 0, columns = 0;  ///< of a grid, as in Mesh; 0: a general mesh
    SharedBuffer<Vec4> positions;         ///< where the cloth starts [m]; w unused
    SharedBuffer<float>
        rest_area;  ///< a third of the rest area of the particle's triangles [m^2]; 0 for loose particles

    SharedBuffer<float> stiffness;  ///< factor of membrane stiffness at each particle; empty: 1, see Map

    /// Springs, each stored at both its ends (half-edges), so that a particle gathers all that acts on it.
    SharedBuffer<std::uint32_t> spring_offsets;
    SharedBuffer<std::uint32_t> neighbours;
    SharedBuffer<float> rest_lengths;  ///< [m]; the same float at both ends
    SharedBuffer<SpringKind> kinds;
    float bending_ratio = 1;  ///< Fabric::bending_ratio that `bending` is made for
    /// Linear bending of rigidity 1 N m: the force on i is the sum of weights times (x_j - x_i) [1/m^2].
    SharedBuffer<float> bending;
    /// Excess of bending's diagonal in relaxation over the sum of its weights, by which it bounds half of the
    /// Hessian: sum of k |c_i| (S - |c_i|) over elements, S being half the sum of their |c| [1/m^2].
    SharedBuffer<float> bending_excess;

    SharedBuffer<Triangle> triangles;  ///< particle indices
    /// With a pattern: each triangle's sides from its corner 0 to corners 1 and 2, in its panel's plane [m];
    /// else none.
    SharedBuffer<std::array<Vec2, 2>> panel_sides;
    SharedBuffer<std::uint32_t> corner_offsets;  ///< triangles of each particle
    SharedBuffer<std::uint32_t> corner_triangles;

    /// Connected components, particles of each in ascending order.
    SharedBuffer<std::uint32_t> component_offsets, component_particles;

    SharedBuffer<std::uint32_t> vertex_to_particle;
    SharedBuffer<Vec2> texcoords;  ///< of vertices, or none
    /// With texture coordinates: the triangles by vertices; empty where each vertex is the particle of its
    /// number.
    SharedBuffer<Triangle> vertex_triangles;
    ClothInfo info;                 ///< mass and bytes are filled in by the cloth
    std::uint32_t fingerprint = 0;  ///< hash of the triangles, and of the particles' numbers
};

/// Computes ClothModel::fingerprint. Precondition: the model has all of its lists.
[[nodiscard]] std::uint32_t fingerprint_of(const ClothModel& model);

/// The corner at which a triangle has a particle. Precondition: it has the particle.
[[nodiscard]] inline std::uint32_t corner_at(const Triangle& triangle, std::uint32_t particle) {
    return triangle[0] == particle ? 0 : triangle[1] == particle ? 1 : 2;
}

/// The half-edge from particle i to j. Precondition: they have one.
[[nodiscard]] std::uint32_t half_edge_between(const ClothModel& model, std::uint32_t i, std::uint32_t j);
/// The rest length of the half-edge from particle i to j [m]. Precondition: they have one.
[[nodiscard]] inline double rest_length_between(const ClothModel& model, std::uint32_t i, std::uint32_t j) {
    return static_cast<double>(model.rest_lengths[half_edge_between(model, i, j)]);
}

/// Cooks a mesh. Error: see build_topology; or rows and columns whose numbering or triangles are not a
/// grid's. Fills `report` unless it is null. Reports to `progress` the first part of cooking, to `modelled`.
[[nodiscard]] Result<ClothModel> cook(const Mesh& mesh, float bending_ratio = 1, CookReport* report = nullptr,
                                      const Progress& progress = {});

/// The model as cooked with that ratio. It shares all lists that do not depend on it.
[[nodiscard]] ClothModel with_bending_ratio(ClothModel model, float bending_ratio);

}  // namespace weft
