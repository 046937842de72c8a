#include "cloth/mesh/topology/repair.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "cloth/mesh/mesh_limits.h"
#include "engine/joined_sets.h"
#include "engine/vector.h"

namespace weft {

namespace {

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
    std::vector<std::array<std::uint32_t, 2>> opposites;  // of each edge, in its kept triangles
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
    // Sides ascend by their particles: a triangle's first side is opposite its highest particle, its last
    // side opposite its lowest.
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

/// The edges of each triangle.
std::vector<std::array<std::uint32_t, 3>> edges_of_triangles(const Topology& topology) {
    constexpr std::uint32_t none = Edge::none;
    std::vector<std::array<std::uint32_t, 3>> edges(topology.triangles.size(), {none, none, none});
    for (std::uint32_t e = 0; e < topology.edges.size(); ++e)
        for (const std::uint32_t t : topology.edges[e].triangles)
            if (t != Edge::none) *std::ranges::find(edges[t], none) = e;
    return edges;
}

/// An edge of one triangle, by its places: numbers of positions, see weld().
struct OpenEdge {
    std::uint32_t low, high;                ///< of the edge, low < high
    std::uint32_t lower, higher, opposite;  ///< vertices at `low`, at `high`, and the triangle's third
    bool ascends;                           ///< the triangle runs along it from low to high
    bool is_matched;
};

bool has_three_places(const Triangle& t, std::span<const std::uint32_t> places) {
    return places[t[0]] != places[t[1]] && places[t[1]] != places[t[2]] && places[t[2]] != places[t[0]];
}

/// The open edges of a mesh. Those at the same places follow one another, by triangles. A triangle with two
/// corners at one place has no edges: those beside it then lie at the same places.
std::vector<OpenEdge> open_edges(const Mesh& mesh, std::span<const std::uint32_t> places) {
    std::vector<Triangle> triangles;
    for (const Triangle& t : mesh.triangles)
        if (has_three_places(t, places)) triangles.push_back(t);
    const std::vector<Side> sides = sides_by_edge(triangles);
    std::vector<OpenEdge> open;
    for (std::size_t begin = 0; begin < sides.size();) {
        const std::span<const Side> same = sides_of_edge(sides, begin);
        begin += same.size();
        if (same.size() > 1) continue;
        std::uint32_t lower = same[0].low, higher = same[0].high;
        if (places[lower] > places[higher]) std::swap(lower, higher);
        const Triangle& triangle = triangles[same[0].triangle];
        const std::size_t at =
            static_cast<std::size_t>(std::ranges::find(triangle, lower) - triangle.begin());
        open.push_back({places[lower], places[higher], lower, higher, same[0].opposite,
                        triangle[(at + 1) % 3] == higher, false});
    }
    std::ranges::stable_sort(open, {}, [](const OpenEdge& e) { return std::pair(e.low, e.high); });
    return open;
}

/// Returns true if the triangles of two edges at one place lie on each other: their angle is less than 1e-3.
bool lie_on_each_other(const Mesh& mesh, const OpenEdge& a, const OpenEdge& b) {
    const auto at = [&](std::uint32_t i) { return to_vector(mesh.positions[i]).cast<double>().eval(); };
    const Eigen::Vector3d from = at(a.lower), along = at(a.higher) - from;
    const Eigen::Vector3d normal = along.cross(at(a.opposite) - from),
                          other = along.cross(at(b.opposite) - from);
    return normal.dot(other) > 0 && normal.cross(other).norm() < 1e-3 * normal.norm() * other.norm();
}

/// Whether two edges at one place are a seam. In a pattern they always are, however the panels lie.
bool is_seam(const Mesh& mesh, const OpenEdge& a, const OpenEdge& b) {
    return !mesh.pattern.empty() || !lie_on_each_other(mesh, a, b);
}

/// Joins each edge with the first later edge at its place that is free. Edges that run the other way, as
/// across a seam of one surface, come before those that run alike, as between parts wound against each other.
void join_matching(const Mesh& mesh, std::span<OpenEdge> same, JoinedSets& sets) {
    for (const bool runs_alike : {false, true}) {
        for (std::size_t k = 0; k < same.size(); ++k) {
            OpenEdge& edge = same[k];
            if (edge.is_matched) continue;
            const auto other = std::find_if(
                same.begin() + static_cast<std::ptrdiff_t>(k) + 1, same.end(), [&](const OpenEdge& e) {
                    return !e.is_matched && (e.ascends == edge.ascends) == runs_alike &&
                           is_seam(mesh, e, edge);
                });
            if (other == same.end()) continue;
            edge.is_matched = other->is_matched = true;
            sets.join(edge.lower, other->lower);
            sets.join(edge.higher, other->higher);
        }
    }
}

}  // namespace

std::vector<std::uint32_t> weld_open_edges(const Mesh& mesh) {
    const std::vector<std::uint32_t> places = weld(mesh.positions);
    JoinedSets sets(places.size());
    std::vector<OpenEdge> open = open_edges(mesh, places);
    const auto is_elsewhere = [](const OpenEdge& a, const OpenEdge& b) {
        return a.low != b.low || a.high != b.high;
    };
    for (auto begin = open.begin(); begin != open.end();) {
        const auto last = std::adjacent_find(begin, open.end(), is_elsewhere);
        const auto end = last == open.end() ? last : last + 1;
        join_matching(mesh, {begin, end}, sets);
        begin = end;
    }

    std::vector<bool> has_triangle(places.size());
    for (const Triangle& t : mesh.triangles)
        if (has_three_places(t, places))
            for (const std::uint32_t vertex : t) has_triangle[vertex] = true;
    std::vector<std::uint32_t> first_at(places.size(), Edge::none);
    for (const bool with_triangle : {true, false})
        for (std::uint32_t i = 0; i < places.size(); ++i)
            if (has_triangle[i] == with_triangle && first_at[places[i]] == Edge::none)
                first_at[places[i]] = i;
    for (std::uint32_t i = 0; i < places.size(); ++i)
        if (!has_triangle[i]) sets.join(i, first_at[places[i]]);
    return sets.numbers();
}

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

std::uint32_t count_misoriented(const Topology& topology) {
    return static_cast<std::uint32_t>(std::ranges::count_if(
        topology.edges, [&](const Edge& edge) { return is_misoriented(topology, edge); }));
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
