#include "cloth/mesh/cooking/ordering.h"

#include <algorithm>
#include <tuple>

namespace weft {

namespace {

constexpr std::uint32_t window = 256;  // wide enough to fill groups, narrow enough to keep neighbours near

/// Particles joined by edges, in compressed rows.
struct Graph {
    std::vector<std::uint32_t> offsets, neighbours;

    [[nodiscard]] std::span<const std::uint32_t> row(std::uint32_t i) const {
        return std::span(neighbours).subspan(offsets[i], degree(i));
    }
    [[nodiscard]] std::uint32_t degree(std::uint32_t i) const { return offsets[i + 1] - offsets[i]; }
};

/// Makes the graph. Its rows ascend by degree, the order of visits of Cuthill and McKee.
Graph graph_of(const Topology& topology) {
    Graph graph;
    graph.offsets.assign(topology.particle_count() + 1, 0);
    graph.neighbours.resize(2 * topology.edges.size());
    for (const Edge& edge : topology.edges)
        for (const std::uint32_t i : edge.particles) ++graph.offsets[i + 1];
    for (std::size_t i = 1; i < graph.offsets.size(); ++i) graph.offsets[i] += graph.offsets[i - 1];
    std::vector<std::uint32_t> next(graph.offsets.begin(), graph.offsets.end() - 1);
    for (const Edge& edge : topology.edges) {
        const auto [a, b] = edge.particles;
        graph.neighbours[next[a]++] = b;
        graph.neighbours[next[b]++] = a;
    }
    for (std::uint32_t i = 0; i < topology.particle_count(); ++i) {
        const auto begin = graph.neighbours.begin();
        std::sort(begin + graph.offsets[i], begin + graph.offsets[i + 1],
                  [&](std::uint32_t p, std::uint32_t q) {
                      return std::pair(graph.degree(p), p) < std::pair(graph.degree(q), q);
                  });
    }
    return graph;
}

/// The number of the last search that visited each particle.
struct Visits {
    std::vector<std::uint32_t> of;
    std::uint32_t search = 0;
};

/// Appends particles to `found`, breadth first from `start`. Returns where the last level begins in it.
std::size_t spread(const Graph& graph, std::uint32_t start, Visits& visits,
                   std::vector<std::uint32_t>& found) {
    ++visits.search;
    visits.of[start] = visits.search;
    std::size_t level = found.size(), at = level;
    found.push_back(start);
    for (std::size_t level_end = found.size(); at < level_end; level_end = found.size()) {
        level = at;
        for (; at < level_end; ++at) {
            for (const std::uint32_t j : graph.row(found[at])) {
                if (visits.of[j] == visits.search) continue;
                visits.of[j] = visits.search;
                found.push_back(j);
            }
        }
    }
    return level;
}

/// A particle that is far from others of its component, from which levels are many and narrow (George and Liu
/// 1979, with as many rounds as usually help).
std::uint32_t far_from(const Graph& graph, std::uint32_t start, Visits& visits) {
    constexpr int rounds = 3;
    std::vector<std::uint32_t> found;
    for (int round = 0; round < rounds; ++round) {
        found.clear();
        const std::size_t last_level = spread(graph, start, visits, found);
        start = *std::min_element(found.begin() + static_cast<std::ptrdiff_t>(last_level), found.end(),
                                  [&](std::uint32_t p, std::uint32_t q) {
                                      return std::pair(graph.degree(p), p) < std::pair(graph.degree(q), q);
                                  });
    }
    return start;
}

/// Estimates the number of particles that each is coupled to: along its edges, and across those opposite to
/// it. Bending in rings couples more; only the order of the counts matters.
std::vector<std::uint32_t> coupling_counts(const Topology& topology) {
    std::vector<std::uint32_t> counts(topology.particle_count(), 0);
    for (const Edge& edge : topology.edges) {
        for (const std::uint32_t i : edge.particles) ++counts[i];
        if (edge.is_border()) continue;
        for (const std::uint32_t i : edge.opposites) ++counts[i];
    }
    return counts;
}

}  // namespace

// E. Cuthill, J. McKee 1969; reversed by A. George 1971. Windows: sliced ELLPACK, see stencil.h.
std::vector<std::uint32_t> memory_order(const Topology& topology) {
    const Graph graph = graph_of(topology);
    Visits visits{std::vector<std::uint32_t>(topology.particle_count(), 0), 0};
    std::vector<std::uint32_t> order;
    order.reserve(topology.particle_count());
    for (std::size_t c = 0; c + 1 < topology.component_offsets.size(); ++c) {
        const std::uint32_t first = topology.component_particles[topology.component_offsets[c]];
        const auto begin = static_cast<std::ptrdiff_t>(order.size());
        spread(graph, far_from(graph, first, visits), visits, order);
        std::reverse(order.begin() + begin, order.end());
    }
    const std::vector<std::uint32_t> counts = coupling_counts(topology);
    for (std::size_t begin = 0; begin < order.size(); begin += window) {
        const auto of_window =
            std::span(order).subspan(begin, std::min<std::size_t>(window, order.size() - begin));
        std::ranges::stable_sort(of_window, std::greater<>{}, [&](std::uint32_t i) { return counts[i]; });
    }
    return order;
}

void renumber(Topology& topology, std::span<const std::uint32_t> order) {
    std::vector<std::uint32_t> numbers(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) numbers[order[i]] = i;
    const auto rename = [&](std::uint32_t& i) { i = numbers[i]; };

    const std::vector<std::uint32_t> first_vertices = topology.first_vertices;
    for (std::uint32_t i = 0; i < order.size(); ++i) topology.first_vertices[i] = first_vertices[order[i]];
    std::ranges::for_each(topology.vertex_to_particle, rename);
    for (Triangle& triangle : topology.triangles) std::ranges::for_each(triangle, rename);
    for (Edge& edge : topology.edges) {
        std::ranges::for_each(edge.particles, rename);
        std::ranges::sort(edge.particles);
        std::ranges::for_each(edge.opposites, [&](std::uint32_t& i) {
            if (i != Edge::none) rename(i);
        });
    }
    std::ranges::sort(topology.edges, {}, &Edge::particles);
    build_components(topology);
}

}  // namespace weft
