#pragma once
// The topology of a mesh: particles, triangles, edges and components. Its only measure is rest area:
// triangles without area are left out, and where two parts are wound against each other the smaller one is
// turned. Slivers are flipped away.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "weft/cooked_cloth.h"
#include "weft/error.h"
#include "weft/mesh.h"

namespace weft {

/// An edge of one triangle (a border) or of two.
struct Edge {
    static constexpr std::uint32_t none = ~0u;

    std::array<std::uint32_t, 2> particles{};            ///< ascending
    std::array<std::uint32_t, 2> triangles{none, none};  ///< ascending; the second is `none` on a border
    std::array<std::uint32_t, 2> opposites{none, none};  ///< the third particle of each of these triangles

    [[nodiscard]] bool is_border() const noexcept { return triangles[1] == none; }
};

/// As built, particles are numbered by their first vertex, ascending, so that a mesh without seams keeps its
/// numbers; see ordering.h.
struct Topology {
    std::vector<std::uint32_t> vertex_to_particle;
    std::vector<std::uint32_t> first_vertices;  ///< of each particle
    std::vector<Triangle> triangles;            ///< particle indices, in the mesh's order
    std::vector<Triangle> corners;  ///< the same triangles in vertex indices, for what differs at seams
    std::vector<Edge> edges;        ///< ascending by particles, each once

    /// Particles that are joined by edges, those of each component in ascending order; components ascend by
    /// their first particle. A loose particle is a component of its own.
    std::vector<std::uint32_t> component_offsets, component_particles;

    std::vector<std::uint32_t> sources;  ///< of each triangle: its number in the mesh
    std::vector<CookReport::Dropped> dropped;
    std::vector<std::uint32_t> turned;   ///< by their numbers in the mesh
    std::vector<std::uint32_t> flipped;  ///< by their numbers in the mesh, see flip_slivers()
    /// An edge that was flipped away: its ends, and the sliver's apex, which lies beside it.
    struct Replaced {
        std::array<std::uint32_t, 2> particles;  ///< ascending
        std::uint32_t apex;
    };
    std::vector<Replaced> replaced;  ///< in the order of the flips
    std::uint32_t misoriented_edges = 0;
    std::uint32_t border_edges = 0;
    std::uint32_t loose_particles = 0;

    [[nodiscard]] std::uint32_t particle_count() const noexcept {
        return static_cast<std::uint32_t>(first_vertices.size());
    }
};

/// Builds the topology. Leaves out, turns and flips triangles as CookReport says. Error: see check_mesh; or
/// no triangle that has an area.
[[nodiscard]] Result<Topology> build_topology(const Mesh& mesh);

/// Finds the edges of the present triangles. Precondition: no edge has more than two.
void build_edges(Topology& topology);

/// Whether a triangle has an area: it is neither lower than least_relative_height nor below least_area.
[[nodiscard]] bool has_area(const Mesh& mesh, const Triangle& vertices);

/// Finds the components of the present edges and particles.
void build_components(Topology& topology);

/// Checks a mesh. Error, which names the element and its value: coordinates that are not finite or too large,
/// an index out of range, no triangles, arrays whose sizes do not fit each other.
[[nodiscard]] Result<void> check_mesh(const Mesh& mesh);

/// The position of a vertex in the rest shape [m]: in the pattern's plane, or in space for a mesh without a
/// pattern.
[[nodiscard]] Eigen::Vector3d rest_point(const Mesh& mesh, std::uint32_t vertex);

/// Area in the rest shape [m^2] of a triangle of vertices.
[[nodiscard]] double rest_area(const Mesh& mesh, const Triangle& vertices);

/// One number per vertex: vertices at equal positions (-0 equals 0) share it, and numbers ascend by first
/// vertex.
[[nodiscard]] std::vector<std::uint32_t> weld(std::span<const Vec3> positions);

/// The edge of two particles; null: they have none.
[[nodiscard]] const Edge* find_edge(const Topology& topology, std::uint32_t a, std::uint32_t b);

}  // namespace weft
