#include "cloth/mesh/repair.h"

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>
#include <utility>

#include "cloth/mesh/mesh_limits.h"

namespace weft {

namespace {

std::vector<Side> sides_by_edge(std::span<const Triangle> triangles) {
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t from = triangles[t][corner];
            const std::uint32_t to = triangles[t][(corner + 1) % 3];
            const std::uint32_t opposite = triangles[t][(corner + 2) % 3];
            sides.push_back({std::min(from, to), std::max(from, to), t, opposite});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    return sides;
}

/// Whether all triangles can stay: no edge has more than two of them, no two are of the same particles, and
/// no particle has too many.
bool are_simple(std::span<const Side> sides, std::span<const std::uint32_t> counts) {
    for (std::size_t begin = 0; begin < sides.size();) {
        const std::span<const Side> same = sides_of_edge(sides, begin);
        begin += same.size();
        if (same.size() > 2 || (same.size() == 2 && same[0].opposite == same[1].opposite)) return false;
    }
    return std::ranges::all_of(counts,
                               [](std::uint32_t count) { return count <= most_triangles_at_particle; });
}

void keep_what_finds_room(std::span<const Side> sides, Topology& topology) {
    const std::size_t count = topology.triangles.size();
    std::vector<std::uint32_t> edge_of_side(3 * count), at_edge, at_particle(topology.particle_count());
    std::vector<std::array<std::uint32_t, 2>> opposites;  // of each edge, of the triangles that it has
    std::vector<std::uint32_t> sides_found(count);
    for (std::size_t begin = 0; begin < sides.size();) {
        const std::span<const Side> same = sides_of_edge(sides, begin);
        begin += same.size();
        for (const Side& side : same)
            edge_of_side[3 * side.triangle + sides_found[side.triangle]++] =
                static_cast<std::uint32_t>(at_edge.size());
        at_edge.push_back(0);
        opposites.push_back({Edge::none, Edge::none});
    }
    // Sides ascend by their particles: a triangle's first is opposite its highest particle, its last its
    // lowest.
    const auto reason_against = [&](std::uint32_t t) -> std::optional<DropReason> {
        const Triangle& particles = topology.triangles[t];
        const std::uint32_t first = edge_of_side[3 * t], highest = std::ranges::max(particles);
        const auto& there = opposites[first];
        if (there[0] == highest || there[1] == highest) return DropReason::doubled;
        for (std::size_t k = 0; k < 3; ++k)
            if (at_edge[edge_of_side[3 * t + k]] == 2) return DropReason::crowded_edge;
        for (const std::uint32_t i : particles)
            if (at_particle[i] == most_triangles_at_particle) return DropReason::crowded_vertex;
        return std::nullopt;
    };
    std::uint32_t kept = 0;
    for (std::uint32_t t = 0; t < count; ++t) {
        if (const auto reason = reason_against(t)) {
            topology.dropped.push_back({topology.sources[t], *reason});
            continue;
        }
        const std::uint32_t first = edge_of_side[3 * t];
        opposites[first][at_edge[first]] = std::ranges::max(topology.triangles[t]);
        for (std::size_t k = 0; k < 3; ++k) ++at_edge[edge_of_side[3 * t + k]];
        for (const std::uint32_t i : topology.triangles[t]) ++at_particle[i];
        topology.triangles[kept] = topology.triangles[t];
        topology.corners[kept] = topology.corners[t];
        topology.sources[kept++] = topology.sources[t];
    }
    topology.triangles.resize(kept);
    topology.corners.resize(kept);
    topology.sources.resize(kept);
    std::ranges::sort(topology.dropped, {}, &CookReport::Dropped::triangle);
}

/// Whether a triangle runs along an edge from its lower particle to its higher one.
bool ascends(const Triangle& triangle, const Edge& edge) {
    const auto [low, high] = edge.particles;
    for (std::size_t k = 0; k < 3; ++k)
        if (triangle[k] == low) return triangle[(k + 1) % 3] == high;
    return false;
}

bool is_misoriented(const Topology& topology, const Edge& edge) {
    return !edge.is_border() && ascends(topology.triangles[edge.triangles[0]], edge) ==
                                    ascends(topology.triangles[edge.triangles[1]], edge);
}

/// The triangles that edges join to each.
std::vector<std::array<std::uint32_t, 3>> edges_of_triangles(const Topology& topology) {
    constexpr std::uint32_t none = Edge::none;
    std::vector<std::array<std::uint32_t, 3>> edges(topology.triangles.size(), {none, none, none});
    for (std::uint32_t e = 0; e < topology.edges.size(); ++e)
        for (const std::uint32_t t : topology.edges[e].triangles)
            if (t != Edge::none) *std::ranges::find(edges[t], none) = e;
    return edges;
}

std::uint32_t count_misoriented(const Topology& topology) {
    return static_cast<std::uint32_t>(std::ranges::count_if(
        topology.edges, [&](const Edge& edge) { return is_misoriented(topology, edge); }));
}

}  // namespace

/// The sides of an edge that begin at `begin`.
std::span<const Side> sides_of_edge(std::span<const Side> sides, std::size_t begin) {
    std::size_t end = begin + 1;
    while (end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high)
        ++end;
    return sides.subspan(begin, end - begin);
}

std::vector<std::uint32_t> triangle_counts(const Topology& topology) {
    std::vector<std::uint32_t> counts(topology.particle_count(), 0);
    for (const Triangle& triangle : topology.triangles)
        for (const std::uint32_t particle : triangle) ++counts[particle];
    return counts;
}

std::vector<Side> leave_out_crowding(Topology& topology) {
    std::vector<Side> sides = sides_by_edge(topology.triangles);
    if (are_simple(sides, triangle_counts(topology))) return sides;
    keep_what_finds_room(sides, topology);
    return sides_by_edge(topology.triangles);
}

void turn_alike(const Mesh& mesh, Topology& topology) {
    topology.misoriented_edges = count_misoriented(topology);
    if (topology.misoriented_edges == 0) return;
    enum : std::uint8_t { as_first, other, unseen };
    const std::vector<std::array<std::uint32_t, 3>> edges = edges_of_triangles(topology);
    std::vector<std::uint8_t> winding(topology.triangles.size(), unseen);
    std::vector<std::uint32_t> piece;
    for (std::uint32_t start = 0; start < topology.triangles.size(); ++start) {
        if (winding[start] != unseen) continue;
        winding[start] = as_first;
        piece.assign({start});
        std::array<double, 2> area{};
        bool can_be_alike = true;
        for (std::size_t k = 0; k < piece.size(); ++k) {
            const std::uint32_t t = piece[k];
            area[winding[t]] += rest_area(mesh, topology.corners[t]);
            for (const std::uint32_t e : edges[t]) {
                const Edge& edge = topology.edges[e];
                if (edge.is_border()) continue;
                const std::uint32_t next = edge.triangles[edge.triangles[0] == t ? 1 : 0];
                const bool against = is_misoriented(topology, edge);
                const std::uint8_t wound = against ? 1 - winding[t] : winding[t];
                if (winding[next] == unseen) {
                    winding[next] = wound;
                    piece.push_back(next);
                }
                can_be_alike = can_be_alike && winding[next] == wound;
            }
        }
        if (!can_be_alike) continue;
        const std::uint8_t turned = area[other] > area[as_first] ? as_first : other;
        for (const std::uint32_t t : piece)
            if (winding[t] == turned) topology.turned.push_back(t);
    }
    std::ranges::sort(topology.turned);
    for (std::uint32_t& t : topology.turned) {
        std::swap(topology.triangles[t][1], topology.triangles[t][2]);
        std::swap(topology.corners[t][1], topology.corners[t][2]);
        t = topology.sources[t];
    }
    topology.misoriented_edges = count_misoriented(topology);
}

}  // namespace weft
