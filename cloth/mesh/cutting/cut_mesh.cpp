// The mesh after a cut along edges.

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include "cloth/mesh/topology/topology.h"
#include "engine/joined_sets.h"
#include "engine/memory/without_exceptions.h"
#include "weft/cutting.h"

namespace weft {

namespace {

/// Corner k of triangle t is number 3 t + k.
constexpr std::uint32_t corner_number(std::uint32_t triangle, std::uint32_t k) {
    return 3 * triangle + k;
}
std::uint32_t corner_of(const Topology& topology, std::uint32_t triangle, std::uint32_t particle) {
    const Triangle& particles = topology.triangles[triangle];
    const auto at = std::ranges::find(particles, particle) - particles.begin();
    return corner_number(triangle, static_cast<std::uint32_t>(at));
}

/// Marks the edge of two particles, or the two sides of the sliver that it was flipped away from. False:
/// there is no such edge.
bool mark(const Topology& topology, std::uint32_t a, std::uint32_t b, std::vector<std::uint8_t>& marks) {
    if (const Edge* const edge = find_edge(topology, a, b)) {
        marks[static_cast<std::size_t>(edge - topology.edges.data())] = 1;
        return true;
    }
    const std::array ends{std::min(a, b), std::max(a, b)};
    const auto flip = std::ranges::find(topology.replaced, ends, &Topology::Replaced::particles);
    return flip != topology.replaced.end() && mark(topology, a, flip->apex, marks) &&
           mark(topology, flip->apex, b, marks);
}

/// Marks these edges of the topology. Error: an edge that it does not have.
Result<std::vector<std::uint8_t>> marked(const Topology& topology, std::span<const MeshEdge> edges) {
    std::vector<std::uint8_t> marks(topology.edges.size());
    for (std::size_t k = 0; k < edges.size(); ++k) {
        for (const std::uint32_t vertex : edges[k])
            if (vertex >= topology.vertex_to_particle.size())
                return Error{ErrorCode::invalid_argument,
                             "edge " + std::to_string(k) + " ends at vertex " + std::to_string(vertex) +
                                 "; the mesh has " + std::to_string(topology.vertex_to_particle.size())};
        const auto [a, b] = edges[k];
        if (!mark(topology, topology.vertex_to_particle[a], topology.vertex_to_particle[b], marks))
            return Error{ErrorCode::invalid_argument,
                         "edge " + std::to_string(k) + " is from vertex " + std::to_string(a) +
                             " to vertex " + std::to_string(b) + ", between which the mesh has none"};
    }
    return marks;
}

/// Fans of corners that uncut edges join at a particle.
JoinedSets fans_without(const Topology& topology, std::span<const std::uint8_t> cut) {
    JoinedSets fans(3 * topology.triangles.size());
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        const Edge& edge = topology.edges[e];
        if (cut[e] != 0 || edge.is_border()) continue;
        for (const std::uint32_t particle : edge.particles)
            fans.join(corner_of(topology, edge.triangles[0], particle),
                      corner_of(topology, edge.triangles[1], particle));
    }
    return fans;
}

/// Whether a cut comes to each particle.
std::vector<std::uint8_t> touched_by(const Topology& topology, std::span<const std::uint8_t> cut) {
    std::vector<std::uint8_t> touched(topology.particle_count());
    for (std::size_t e = 0; e < topology.edges.size(); ++e)
        if (cut[e] != 0 && !topology.edges[e].is_border())
            for (const std::uint32_t particle : topology.edges[e].particles) touched[particle] = 1;
    return touched;
}

/// A corner of a particle that a cut comes to.
struct ParentCorner {
    std::uint32_t vertex, fan, corner;
    [[nodiscard]] bool has_vertex_of(const ParentCorner& other) const {
        return vertex == other.vertex && fan == other.fan;
    }
};

template <class T>
void append_copy(std::vector<T>& list, std::uint32_t of) {
    if (list.empty()) return;
    const T copied = list[of];
    list.push_back(copied);
}

/// Appends a copy of a vertex and returns its number.
std::uint32_t add_vertex(MeshCut& cut, std::uint32_t of) {
    append_copy(cut.mesh.positions, of);
    append_copy(cut.mesh.pattern, of);
    append_copy(cut.mesh.texcoords, of);
    cut.mesh.welds.push_back(cut.mesh.welds[of]);
    cut.from.push_back(cut.from[of]);
    return static_cast<std::uint32_t>(cut.mesh.positions.size() - 1);
}

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// Corners of particles that a cut comes to, by vertices and in these by fans.
std::vector<ParentCorner> corners_at(const Topology& topology, JoinedSets& fans,
                                     std::span<const std::uint8_t> touched) {
    std::vector<ParentCorner> corners;
    for (std::uint32_t t = 0; t < topology.triangles.size(); ++t)
        for (std::uint32_t k = 0; k < 3; ++k)
            if (const std::uint32_t number = corner_number(t, k); touched[topology.triangles[t][k]] != 0)
                corners.push_back({topology.corners[t][k], fans.first_of(number), number});
    std::ranges::sort(corners, {}, [](const ParentCorner& c) { return std::tie(c.vertex, c.fan, c.corner); });
    return corners;
}

/// Makes each fan a particle. A vertex of several fans stays with the first one, and the others get copies.
/// Vertices of no triangle go with the first fan of their particle.
void part(const Topology& topology, JoinedSets& fans, std::span<const std::uint8_t> touched, MeshCut& cut) {
    struct InFan {
        std::uint32_t vertex, fan;
    };
    std::vector<InFan> vertices;
    std::vector<std::uint32_t> fan_of_particle(topology.particle_count(), none);
    std::vector<std::uint8_t> is_used(topology.vertex_to_particle.size());
    const std::vector<ParentCorner> corners = corners_at(topology, fans, touched);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const ParentCorner& corner = corners[i];
        if (i == 0 || !corner.has_vertex_of(corners[i - 1])) {
            const bool keeps = i == 0 || corner.vertex != corners[i - 1].vertex;
            vertices.push_back({keeps ? corner.vertex : add_vertex(cut, corner.vertex), corner.fan});
        }
        cut.mesh.triangles[corner.corner / 3][corner.corner % 3] = vertices.back().vertex;
        is_used[corner.vertex] = 1;
        std::uint32_t& fan = fan_of_particle[topology.vertex_to_particle[corner.vertex]];
        fan = std::min(fan, corner.fan);
    }
    for (std::uint32_t v = 0; v < is_used.size(); ++v) {
        const std::uint32_t particle = topology.vertex_to_particle[v];
        if (is_used[v] == 0 && touched[particle] != 0) vertices.push_back({v, fan_of_particle[particle]});
    }
    std::vector<std::uint32_t> first_of_fan(3 * topology.triangles.size(), none);
    for (const auto& [vertex, fan] : vertices) first_of_fan[fan] = std::min(first_of_fan[fan], vertex);
    for (const auto& [vertex, fan] : vertices) cut.mesh.welds[vertex] = first_of_fan[fan];
}

std::uint32_t particles_of(const Mesh& mesh) {
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < mesh.welds.size(); ++v) count += mesh.welds[v] == v ? 1 : 0;
    return count;
}

}  // namespace

Result<MeshCut> cut_mesh(const Mesh& mesh, std::span<const MeshEdge> edges) {
    return without_exceptions([&]() -> Result<MeshCut> {
        const Result<Topology> topology = build_topology(mesh);
        if (!topology) return topology.error();
        const auto cut = marked(*topology, edges);
        if (!cut) return cut.error();

        MeshCut result{.mesh = mesh, .from = std::vector<std::uint32_t>(mesh.positions.size())};
        std::iota(result.from.begin(), result.from.end(), 0u);
        result.mesh.triangles = topology->corners;
        result.mesh.welds.resize(mesh.positions.size());
        for (std::size_t v = 0; v < mesh.positions.size(); ++v)
            result.mesh.welds[v] = topology->first_vertices[topology->vertex_to_particle[v]];

        JoinedSets fans = fans_without(*topology, *cut);
        const std::vector<std::uint8_t> touched = touched_by(*topology, *cut);
        part(*topology, fans, touched, result);
        result.added_particles = particles_of(result.mesh) - topology->particle_count();
        if (result.added_particles == 0) {
            result.mesh = mesh;
            return result;
        }
        result.mesh.rows = result.mesh.columns = 0;
        return result;
    });
}

}  // namespace weft
