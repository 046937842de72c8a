// The edges along which strained cloth tears.

#include <algorithm>
#include <cmath>
#include <string>

#include "cloth/mesh/cutting/check_positions.h"
#include "cloth/mesh/topology/topology.h"
#include "engine/memory/without_exceptions.h"
#include "engine/vector.h"

namespace weft {

Result<void> check_positions(const Mesh& mesh, std::span<const Vec3> positions) {
    if (positions.size() != mesh.positions.size())
        return Error{ErrorCode::invalid_argument, std::to_string(positions.size()) + " positions of " +
                                                      std::to_string(mesh.positions.size()) +
                                                      " vertices; give one for each"};
    for (std::size_t v = 0; v < positions.size(); ++v)
        if (!to_vector(positions[v]).allFinite())
            return Error{ErrorCode::invalid_argument,
                         "the position of vertex " + std::to_string(v) + " is not finite"};
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const std::uint32_t vertex : mesh.triangles[t])
            if (vertex >= positions.size())
                return Error{ErrorCode::invalid_mesh, "triangle " + std::to_string(t) + " has vertex " +
                                                          std::to_string(vertex) + " of " +
                                                          std::to_string(positions.size())};
    return {};
}

namespace {

/// The mesh at its present positions.
struct Lying {
    const Topology& topology;
    std::span<const Vec3> positions;

    [[nodiscard]] Vector3 at(std::uint32_t particle) const {
        return to_vector(positions[topology.first_vertices[particle]]);
    }
    [[nodiscard]] bool is_ahead(std::uint32_t triangle, const Vector3& from, const Vector3& pull) const {
        const auto [a, b, c] = topology.triangles[triangle];
        return ((at(a) + at(b) + at(c)) / 3 - from).dot(pull) > 0;
    }
};

/// Edges at each particle, ascending.
class EdgesOfParticles {
  public:
    explicit EdgesOfParticles(const Topology& topology) : offsets_(topology.particle_count() + 1) {
        for (const Edge& edge : topology.edges)
            for (const std::uint32_t particle : edge.particles) ++offsets_[particle + 1];
        for (std::size_t i = 1; i < offsets_.size(); ++i) offsets_[i] += offsets_[i - 1];
        edges_.resize(2 * topology.edges.size());
        std::vector<std::uint32_t> next(offsets_.begin(), offsets_.end() - 1);
        for (std::uint32_t e = 0; e < topology.edges.size(); ++e)
            for (const std::uint32_t particle : topology.edges[e].particles) edges_[next[particle]++] = e;
    }
    [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t particle) const {
        return std::span(edges_).subspan(offsets_[particle], offsets_[particle + 1] - offsets_[particle]);
    }

  private:
    std::vector<std::uint32_t> offsets_, edges_;
};

/// Edges at the particle whose triangles lie on both sides of the plane across `pull`.
std::vector<MeshEdge> edges_across(const Lying& lying, const EdgesOfParticles& edges, std::uint32_t particle,
                                   const Vector3& pull) {
    std::vector<MeshEdge> across;
    const Topology& topology = lying.topology;
    for (const std::uint32_t e : edges.of(particle)) {
        const Edge& edge = topology.edges[e];
        if (edge.is_border()) continue;
        const Vector3 from = lying.at(particle);
        if (lying.is_ahead(edge.triangles[0], from, pull) == lying.is_ahead(edge.triangles[1], from, pull))
            continue;
        across.push_back(
            {topology.first_vertices[edge.particles[0]], topology.first_vertices[edge.particles[1]]});
    }
    return across;
}

bool is_at_border(const Topology& topology, const EdgesOfParticles& edges, std::uint32_t particle) {
    return std::ranges::any_of(edges.of(particle),
                               [&](std::uint32_t e) { return topology.edges[e].is_border(); });
}

/// A tear: its edges, and whether it runs on from a border.
struct Opening {
    std::vector<MeshEdge> edges;  ///< empty: there is no tear
    bool runs_on = false;
};

/// The tear of one strained edge, at the end where cloth can open; none where it can at neither.
Opening opening_at(const Lying& lying, const EdgesOfParticles& edges, std::uint32_t a, std::uint32_t b) {
    if (is_at_border(lying.topology, edges, b) && !is_at_border(lying.topology, edges, a)) std::swap(a, b);
    const Vector3 pull = lying.at(b) - lying.at(a);
    for (const std::uint32_t end : {a, b}) {
        const bool at_border = is_at_border(lying.topology, edges, end);
        Opening opening{edges_across(lying, edges, end, pull), at_border};
        if (opening.edges.size() >= (at_border ? 1u : 2u)) return opening;
    }
    return {};
}

Result<void> check_strained(std::span<const StrainedEdge> strained, std::size_t vertices) {
    for (const StrainedEdge& edge : strained)
        for (const std::uint32_t vertex : {edge.a, edge.b})
            if (vertex >= vertices)
                return Error{ErrorCode::invalid_argument, "a strained edge ends at vertex " +
                                                              std::to_string(vertex) + "; the mesh has " +
                                                              std::to_string(vertices)};
    return {};
}

}  // namespace

Result<std::vector<MeshEdge>> edges_to_tear(const Mesh& mesh, std::span<const Vec3> positions,
                                            std::span<const StrainedEdge> strained) {
    return without_exceptions([&]() -> Result<std::vector<MeshEdge>> {
        if (strained.empty()) return std::vector<MeshEdge>();
        if (auto checked = check_positions(mesh, positions); !checked) return checked.error();
        if (auto checked = check_strained(strained, positions.size()); !checked) return checked.error();
        const Result<Topology> topology = build_topology(mesh);
        if (!topology) return topology.error();
        const EdgesOfParticles edges(*topology);
        const Lying lying{*topology, positions};
        // A tear that runs on relieves the strain ahead of it, so no new tear opens then.
        Opening first;
        std::vector<MeshEdge> torn;
        for (const StrainedEdge& edge : strained) {
            Opening opening = opening_at(lying, edges, topology->vertex_to_particle[edge.a],
                                         topology->vertex_to_particle[edge.b]);
            if (opening.runs_on)
                torn.insert(torn.end(), opening.edges.begin(), opening.edges.end());
            else if (first.edges.empty())
                first = std::move(opening);
        }
        if (torn.empty()) return std::move(first.edges);
        return torn;
    });
}

}  // namespace weft
