#include "cloth/mesh/topology/flip_slivers.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "cloth/mesh/mesh_limits.h"
#include "cloth/mesh/rest/slivers.h"
#include "cloth/mesh/topology/repair.h"

namespace weft {

namespace {

Eigen::Vector3d normal_of(const Mesh& mesh, const Triangle& vertices) {
    const Eigen::Vector3d origin = rest_point(mesh, vertices[0]);
    return (rest_point(mesh, vertices[1]) - origin).cross(rest_point(mesh, vertices[2]) - origin);
}

/// A triangle laid flat, its first side along x.
RestSides flat_sides(const Mesh& mesh, const Triangle& vertices) {
    const Eigen::Vector3d origin = rest_point(mesh, vertices[0]),
                          to1 = rest_point(mesh, vertices[1]) - origin,
                          to2 = rest_point(mesh, vertices[2]) - origin;
    const double length = to1.norm();
    return {Eigen::Vector2d(length, 0).cast<float>(),
            Eigen::Vector2d(to1.dot(to2) / length, to1.cross(to2).norm() / length).cast<float>()};
}

/// The stiffness of a triangle's springs, times the membrane's modulus; infinite without an area.
double stiffness_of(const Mesh& mesh, const Triangle& vertices) {
    if (!has_area(mesh, vertices)) return std::numeric_limits<double>::infinity();
    return side_strains(flat_sides(mesh, vertices)).stiffness().maxCoeff();
}

std::array<double, 3> squared_sides(const Mesh& mesh, const Triangle& vertices) {
    std::array<double, 3> squares;
    for (std::size_t k = 0; k < 3; ++k)
        squares[k] = (rest_point(mesh, vertices[(k + 1) % 3]) - rest_point(mesh, vertices[k])).squaredNorm();
    return squares;
}

/// Whether a triangle is lower than a sound one.
bool is_low(const Mesh& mesh, const Triangle& vertices) {
    const double longest = std::ranges::max(squared_sides(mesh, vertices));
    return normal_of(mesh, vertices).norm() < least_sound_height * longest;
}

Triangle particles_of(const Topology& topology, const Triangle& vertices) {
    return {topology.vertex_to_particle[vertices[0]], topology.vertex_to_particle[vertices[1]],
            topology.vertex_to_particle[vertices[2]]};
}

/// Numbers in the mesh of triangles without area that were left out and for whose sides edges have room.
std::vector<std::uint32_t> flat_triangles(const Mesh& mesh, const Topology& topology) {
    std::map<std::array<std::uint32_t, 2>, std::uint32_t> at_edge;
    const auto edge_of = [](const Triangle& particles, std::size_t k) -> std::array<std::uint32_t, 2> {
        const auto [low, high] = std::minmax(particles[k], particles[(k + 1) % 3]);
        return {low, high};
    };
    const auto for_each_flat = [&](const auto& body) {
        for (const auto& [t, why] : topology.dropped) {
            if (why != DropReason::no_area) continue;
            const Triangle particles = particles_of(topology, mesh.triangles[t]);
            const auto [a, b, c] = particles;
            if (a != b && b != c && c != a) body(t, particles);
        }
    };
    for_each_flat([&](std::uint32_t /*t*/, const Triangle& particles) {
        for (std::size_t k = 0; k < 3; ++k) ++at_edge[edge_of(particles, k)];
    });
    std::vector<std::uint32_t> found;
    for_each_flat([&](std::uint32_t t, const Triangle& particles) {
        bool has_room = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto ends = edge_of(particles, k);
            const Edge* const edge = find_edge(topology, ends[0], ends[1]);
            const std::uint32_t there = edge == nullptr ? 0 : edge->is_border() ? 1 : 2;
            const bool is_doubled = edge != nullptr && edge->opposites[0] == particles[(k + 2) % 3];
            has_room = has_room && !is_doubled && there + at_edge[ends] <= 2;
        }
        if (has_room) found.push_back(t);
    });
    return found;
}

template <class T>
void permute(std::vector<T>& list, std::span<const std::uint32_t> order) {
    std::vector<T> permuted;
    permuted.reserve(order.size());
    for (const std::uint32_t at : order) permuted.push_back(list[at]);
    list = std::move(permuted);
}

/// The quadrilateral about an edge: it runs from corner `from` of triangle `one` to the next, and back in
/// triangle `other` from its corner `back`.
struct Quad {
    std::uint32_t one, other;
    std::size_t from, back;
};

class Flips {
  public:
    Flips(const Mesh& mesh, Topology& topology) : mesh_(mesh), topology_(topology) {}

    void run() {
        const std::vector<std::uint32_t> flat = flat_triangles(mesh_, topology_);
        for (const std::uint32_t t : flat) {
            topology_.triangles.push_back(particles_of(topology_, mesh_.triangles[t]));
            topology_.corners.push_back(mesh_.triangles[t]);
            topology_.sources.push_back(t);
        }
        for (std::uint32_t t = 0; t < topology_.triangles.size(); ++t) wait_if_sliver(t);
        if (waiting_.empty()) return;
        if (!flat.empty()) build_edges(topology_);
        find_edges();
        counts_ = triangle_counts(topology_);
        for (std::size_t k = 0; k < waiting_.size(); ++k) {
            if (!is_sliver(waiting_[k])) continue;
            const auto quad = quad_about(waiting_[k]);
            if (quad && is_better_flipped(*quad)) flip(*quad);
        }
        for (const std::uint32_t t : flipped_) topology_.flipped.push_back(topology_.sources[t]);
        std::ranges::sort(topology_.flipped);
        if (!flat.empty()) leave_out_flat();
        if (flat.empty() && flipped_.empty()) return;
        build_edges(topology_);
        topology_.misoriented_edges = count_misoriented(topology_);
    }

  private:
    [[nodiscard]] bool is_sliver(std::uint32_t t) const {
        const Triangle& vertices = topology_.corners[t];
        return is_low(mesh_, vertices) && stiffness_of(mesh_, vertices) > greatest_side_stiffness;
    }

    void wait_if_sliver(std::uint32_t t) {
        if (is_sliver(t)) waiting_.push_back(t);
    }

    /// Drops triangles that no flip gave an area. Sorts the others in the mesh's order.
    void leave_out_flat() {
        std::vector<std::uint32_t> kept;
        for (std::uint32_t t = 0; t < topology_.triangles.size(); ++t)
            if (has_area(mesh_, topology_.corners[t])) kept.push_back(t);
        std::ranges::sort(kept, {}, [&](std::uint32_t t) { return topology_.sources[t]; });
        permute(topology_.triangles, kept);
        permute(topology_.corners, kept);
        permute(topology_.sources, kept);
        std::erase_if(topology_.dropped, [&](const CookReport::Dropped& dropped) {
            return std::ranges::binary_search(topology_.sources, dropped.triangle);
        });
    }

    void find_edges() {
        edges_of_.resize(topology_.triangles.size());
        for (std::uint32_t e = 0; e < topology_.edges.size(); ++e) {
            const Edge& edge = topology_.edges[e];
            triangles_at_.push_back(edge.triangles);
            for (const std::uint32_t t : edge.triangles)
                if (t != Edge::none) edges_of_[t][side_of(t, edge)] = e;
        }
    }

    [[nodiscard]] std::uint32_t across(std::uint32_t e, std::uint32_t t) const {
        return triangles_at_[e][triangles_at_[e][0] == t ? 1 : 0];
    }

    /// The corner of a triangle from which an edge of it runs.
    [[nodiscard]] std::size_t side_of(std::uint32_t t, const Edge& edge) const {
        const Triangle& particles = topology_.triangles[t];
        for (std::size_t k = 0; k < 2; ++k)
            if (particles[(k + 2) % 3] != edge.particles[0] && particles[(k + 2) % 3] != edge.particles[1])
                return k;
        return 2;
    }

    [[nodiscard]] std::size_t longest_side(std::uint32_t t) const {
        const std::array<double, 3> squares = squared_sides(mesh_, topology_.corners[t]);
        return static_cast<std::size_t>(std::ranges::max_element(squares) - squares.begin());
    }

    [[nodiscard]] std::optional<Quad> quad_about(std::uint32_t t) const {
        const std::size_t from = longest_side(t);
        const std::uint32_t e = edges_of_[t][from], other = across(e, t);
        if (other == Edge::none) return std::nullopt;
        const auto back =
            static_cast<std::size_t>(std::ranges::find(edges_of_[other], e) - edges_of_[other].begin());
        const Quad quad{t, other, from, back};
        if (topology_.triangles[other][back] == topology_.triangles[t][from]) return std::nullopt;
        const Triangle &here = topology_.corners[t], &there = topology_.corners[other];
        const bool is_seam = here[from] != there[(back + 1) % 3] || here[(from + 1) % 3] != there[back];
        if (is_seam && !(mesh_.pattern.empty() && mesh_.texcoords.empty())) return std::nullopt;
        return quad;
    }

    /// The two triangles after the edge (a, b) of (a, b, c) and (b, a, d) is flipped to run from d to c.
    [[nodiscard]] static std::array<Triangle, 2> turned(const std::vector<Triangle>& triangles,
                                                        const Quad& quad) {
        const Triangle &one = triangles[quad.one], &other = triangles[quad.other];
        const std::uint32_t a = one[quad.from], b = one[(quad.from + 1) % 3], c = one[(quad.from + 2) % 3],
                            d = other[(quad.back + 2) % 3];
        return {Triangle{a, d, c}, Triangle{d, b, c}};
    }

    [[nodiscard]] bool is_better_flipped(const Quad& quad) const {
        const auto particles = turned(topology_.triangles, quad);
        const std::uint32_t c = particles[0][2], d = particles[0][1];
        if (find_edge(topology_, c, d) != nullptr || made_.contains(std::minmax(c, d)) ||
            std::max(counts_[c], counts_[d]) == most_triangles_at_particle)
            return false;
        const auto vertices = turned(topology_.corners, quad);
        const Eigen::Vector3d normal = normal_of(mesh_, topology_.corners[quad.other]);
        double worst = 0;
        for (const Triangle& triangle : vertices) {
            if (normal_of(mesh_, triangle).dot(normal) <= 0 || !has_area(mesh_, triangle)) return false;
            worst = std::max(worst, stiffness_of(mesh_, triangle));
        }
        return worst <= 0.5 * std::max(stiffness_of(mesh_, topology_.corners[quad.one]),
                                       stiffness_of(mesh_, topology_.corners[quad.other]));
    }

    void flip(const Quad& quad) {
        const auto particles = turned(topology_.triangles, quad), vertices = turned(topology_.corners, quad);
        const std::uint32_t a = particles[0][0], d = particles[0][1], c = particles[0][2],
                            b = particles[1][1];
        for (const std::uint32_t i : {a, b}) --counts_[i];
        for (const std::uint32_t i : {c, d}) ++counts_[i];
        made_.insert(std::minmax(c, d));
        topology_.replaced.push_back({{std::min(a, b), std::max(a, b)}, c});

        const auto& of_one = edges_of_[quad.one];
        const auto& of_other = edges_of_[quad.other];
        const std::uint32_t e = of_one[quad.from], b_to_c = of_one[(quad.from + 1) % 3],
                            c_to_a = of_one[(quad.from + 2) % 3], a_to_d = of_other[(quad.back + 1) % 3],
                            d_to_b = of_other[(quad.back + 2) % 3];
        std::ranges::replace(triangles_at_[b_to_c], quad.one, quad.other);
        std::ranges::replace(triangles_at_[a_to_d], quad.other, quad.one);
        edges_of_[quad.one] = {a_to_d, e, c_to_a};
        edges_of_[quad.other] = {d_to_b, b_to_c, e};
        const std::array<std::uint32_t, 2> changed{quad.one, quad.other};
        for (std::size_t k = 0; k < 2; ++k) {
            const std::uint32_t t = changed[k];
            topology_.triangles[t] = particles[k];
            topology_.corners[t] = vertices[k];
            flipped_.insert(t);
            wait_if_sliver(t);
            for (const std::uint32_t side : edges_of_[t])
                if (const std::uint32_t beside = across(side, t); beside != Edge::none && side != e)
                    wait_if_sliver(beside);
        }
    }

    const Mesh& mesh_;
    Topology& topology_;
    std::vector<std::uint32_t> waiting_;
    std::vector<std::array<std::uint32_t, 3>> edges_of_;      ///< by triangles: from each corner to the next
    std::vector<std::array<std::uint32_t, 2>> triangles_at_;  ///< by edges, as they are now
    std::vector<std::uint32_t> counts_;                       ///< of triangles, by particles
    std::set<std::pair<std::uint32_t, std::uint32_t>> made_;  ///< edges that flips made: none is made again
    std::set<std::uint32_t> flipped_;
};

}  // namespace

void flip_slivers(const Mesh& mesh, Topology& topology) {
    Flips(mesh, topology).run();
}

}  // namespace weft
