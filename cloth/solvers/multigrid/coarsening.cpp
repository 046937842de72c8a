#include "cloth/solvers/multigrid/coarsening.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "cloth/system/sparse/stencil.h"

namespace weft {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Which kept node each node is nearest to, along the springs.
struct Voronoi {
    std::vector<float> distance;
    std::vector<std::uint32_t> owner;  // a node of the fine graph
};

/// A distance and a number as one integer, which goes by the distance first: neither is below 0.
std::uint64_t packed(float distance, std::uint32_t number) {
    return std::uint64_t{std::bit_cast<std::uint32_t>(distance)} << 32 | number;
}
float distance_of(std::uint64_t pair) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(pair >> 32));
}

/// Takes and gives the least; keeps its memory.
class Fronts {
  public:
    [[nodiscard]] bool empty() const { return heap_.empty(); }
    void push(std::uint64_t pair) {
        heap_.push_back(pair);
        std::ranges::push_heap(heap_, std::greater());
    }
    std::uint64_t pop() {
        std::ranges::pop_heap(heap_, std::greater());
        const std::uint64_t least = heap_.back();
        heap_.pop_back();
        return least;
    }

  private:
    std::vector<std::uint64_t> heap_;
};

/// Claims for `source` all nodes that are nearer to it than to their present owner (Dijkstra 1959).
void claim(const SpringGraph& graph, std::uint32_t source, Voronoi& voronoi, Fronts& fronts) {
    const auto reach = [&](std::uint32_t node, float distance) {
        if (distance >= voronoi.distance[node]) return;
        voronoi.distance[node] = distance;
        voronoi.owner[node] = source;
        fronts.push(packed(distance, node));
    };
    reach(source, 0);
    while (!fronts.empty()) {
        const std::uint64_t front = fronts.pop();
        const float distance = distance_of(front);
        const auto node = static_cast<std::uint32_t>(front);
        if (distance > voronoi.distance[node]) continue;
        for (std::uint32_t e = graph.offsets[node]; e < graph.offsets[node + 1]; ++e)
            reach(graph.neighbours[e], distance + graph.lengths[e]);
    }
}

/// How many nodes of each component stay.
std::vector<std::uint32_t> wanted_of(const Components& components, float ratio, std::uint32_t most_direct) {
    std::vector<std::uint32_t> wanted(components.count());
    for (std::uint32_t c = 0; c < components.count(); ++c) {
        const std::uint32_t size = components.size(c);
        if (size > most_direct)
            wanted[c] = static_cast<std::uint32_t>(std::ceil(static_cast<float>(size) / ratio));
    }
    return wanted;
}

/// Farthest-point sampling (Gonzalez 1985) in each component by itself: its next node is the one farthest
/// from those before. Nodes that none of them reaches come first.
Voronoi sample_farthest(const SpringGraph& graph, const Components& components,
                        std::vector<std::uint32_t> wanted, std::vector<std::uint32_t>& kept) {
    Voronoi voronoi{std::vector<float>(graph.nodes(), infinity),
                    std::vector<std::uint32_t>(graph.nodes(), 0)};
    // Distances only fall: an entry that is out of date is put back with the present one. Ties go to the
    // lower index.
    std::priority_queue<std::uint64_t> candidates;
    Fronts fronts;
    for (std::uint32_t i = 0; i < graph.nodes(); ++i) {
        if (graph.degree(i) > 0 && wanted[components.of_node[i]] > 0) candidates.push(packed(infinity, ~i));
    }
    while (!candidates.empty()) {
        const std::uint64_t candidate = candidates.top();
        candidates.pop();
        const float distance = distance_of(candidate);
        const std::uint32_t node = ~static_cast<std::uint32_t>(candidate);
        if (voronoi.distance[node] < distance) {
            candidates.push(packed(voronoi.distance[node], ~node));
            continue;
        }
        std::uint32_t& wanted_here = wanted[components.of_node[node]];
        if (wanted_here == 0 && distance < infinity) continue;
        if (wanted_here > 0) --wanted_here;
        kept.push_back(node);
        claim(graph, node, voronoi, fronts);
    }
    std::ranges::sort(kept);
    return voronoi;
}

struct Weight {
    std::uint32_t coarse;
    float value;
};

/// Rows of weights, one after the other.
struct Rows {
    std::vector<std::size_t> offsets{0};
    std::vector<Weight> weights;

    [[nodiscard]] std::span<const Weight> row(std::uint32_t i) const {
        return std::span(weights).subspan(offsets[i], offsets[i + 1] - offsets[i]);
    }
    void end_row() { offsets.push_back(weights.size()); }
};

/// Adds up a row, whose nodes keep the order in which they came.
class RowSum {
  public:
    explicit RowSum(std::uint32_t coarse) : places_(coarse, none) {}

    void add(std::uint32_t coarse, float value) {
        std::uint32_t& place = places_[coarse];
        if (place == none) {
            place = static_cast<std::uint32_t>(row_.size());
            row_.push_back({coarse, value});
        } else {
            row_[place].value += value;
        }
    }
    /// Appends the row over `divisor`, and begins another.
    void move_to(Rows& rows, float divisor) {
        for (const Weight& w : row_) {
            rows.weights.push_back({w.coarse, w.value / divisor});
            places_[w.coarse] = none;
        }
        rows.end_row();
        row_.clear();
    }

  private:
    static constexpr std::uint32_t none = ~0u;
    std::vector<std::uint32_t> places_;  // in the row, by coarse node
    std::vector<Weight> row_;
};

/// One Jacobi sweep of the springs' Laplacian on the weights; kept nodes hold theirs.
Rows smoothed(const SpringGraph& graph, const std::vector<bool>& is_kept, const Rows& rows, RowSum& sum) {
    Rows result;
    result.offsets.reserve(rows.offsets.size());
    result.weights.reserve(2 * rows.weights.size());
    const auto keep = [&](std::uint32_t i) {
        const std::span<const Weight> row = rows.row(i);
        result.weights.insert(result.weights.end(), row.begin(), row.end());
        result.end_row();
    };
    for (std::uint32_t i = 0; i < graph.nodes(); ++i) {
        float stiffness = 0;
        for (std::uint32_t e = graph.offsets[i]; e < graph.offsets[i + 1]; ++e)
            stiffness += graph.stiffness[e];
        if (is_kept[i] || stiffness == 0) {
            keep(i);
            continue;
        }
        for (std::uint32_t e = graph.offsets[i]; e < graph.offsets[i + 1]; ++e)
            for (const Weight& w : rows.row(graph.neighbours[e]))
                sum.add(w.coarse, graph.stiffness[e] * w.value);
        sum.move_to(result, stiffness);
    }
    return result;
}

/// Keeps the largest weights of each row, scaled to sum 1, ascending by node.
void store_rows(const Rows& rows, Interpolation& interpolation) {
    std::vector<Weight> row;
    for (std::uint32_t i = 0; i < interpolation.fine; ++i) {
        row.assign(rows.row(i).begin(), rows.row(i).end());
        std::ranges::sort(row, [](const Weight& a, const Weight& b) {
            return std::pair(-a.value, a.coarse) < std::pair(-b.value, b.coarse);
        });
        row.resize(std::min<std::size_t>(row.size(), Interpolation::width));
        std::ranges::sort(row, {}, &Weight::coarse);
        float sum = 0;
        for (const Weight& w : row) sum += w.value;
        for (std::size_t k = 0; k < row.size(); ++k) {
            interpolation.nodes[Interpolation::width * i + k] = row[k].coarse;
            interpolation.weights[Interpolation::width * i + k] = row[k].value / sum;
        }
    }
}

void store_transpose(Interpolation& p) {
    std::uint32_t used = 0;
    for (const float weight : p.weights.span()) used += weight != 0;
    p.offsets = AlignedBuffer<std::uint32_t>(p.coarse + 1);
    p.fine_nodes = AlignedBuffer<std::uint32_t>(used);
    p.fine_weights = AlignedBuffer<float>(used);
    for (std::size_t e = 0; e < p.weights.size(); ++e) {
        if (p.weights[e] != 0) ++p.offsets[p.nodes[e] + 1];
    }
    for (std::uint32_t c = 0; c < p.coarse; ++c) p.offsets[c + 1] += p.offsets[c];
    std::vector<std::uint32_t> next(p.offsets.data(), p.offsets.data() + p.coarse);
    for (std::size_t e = 0; e < p.weights.size(); ++e) {
        if (p.weights[e] == 0) continue;
        const std::uint32_t at = next[p.nodes[e]]++;
        p.fine_nodes[at] = static_cast<std::uint32_t>(e / Interpolation::width);
        p.fine_weights[at] = p.weights[e];
    }
}

}  // namespace

Components components_of(const SpringGraph& graph) {
    constexpr std::uint32_t none = ~0u;
    Components result{
        .of_node = std::vector<std::uint32_t>(graph.nodes(), none), .offsets = {0}, .nodes = {}};
    for (std::uint32_t first = 0; first < graph.nodes(); ++first) {
        if (result.of_node[first] != none) continue;
        const std::uint32_t component = result.count();
        const auto reach = [&](std::uint32_t node) {
            if (std::exchange(result.of_node[node], component) != component) result.nodes.push_back(node);
        };
        reach(first);
        for (std::size_t k = result.offsets.back(); k < result.nodes.size(); ++k) {
            const std::uint32_t node = result.nodes[k];
            for (std::uint32_t e = graph.offsets[node]; e < graph.offsets[node + 1]; ++e)
                reach(graph.neighbours[e]);
        }
        std::sort(result.nodes.begin() + result.offsets.back(), result.nodes.end());
        result.offsets.push_back(static_cast<std::uint32_t>(result.nodes.size()));
    }
    return result;
}

// Weights start as the nearest kept node's and are smoothed towards harmonic ones: energy-minimising as far
// as four sweeps go (after Mandel, Brezina, Vanek 1999).
Coarsening coarsen(const SpringGraph& graph, const Components& components, float ratio,
                   std::uint32_t most_direct) {
    constexpr int sweeps = 4;
    std::vector<std::uint32_t> kept;
    Voronoi voronoi = sample_farthest(graph, components, wanted_of(components, ratio, most_direct), kept);
    kept.shrink_to_fit();
    Interpolation p(graph.nodes(), static_cast<std::uint32_t>(kept.size()));
    p.kept = std::move(kept);

    std::vector<bool> is_kept(graph.nodes(), false);
    std::vector<std::uint32_t> coarse_of(graph.nodes(), 0);
    for (std::uint32_t c = 0; c < p.coarse; ++c) {
        is_kept[p.kept[c]] = true;
        coarse_of[p.kept[c]] = c;
    }
    Rows rows;
    for (std::uint32_t i = 0; i < graph.nodes(); ++i) {
        if (voronoi.distance[i] != infinity) {  // else nobody's
            voronoi.owner[i] = coarse_of[voronoi.owner[i]];
            rows.weights.push_back({voronoi.owner[i], 1.0f});
        }
        rows.end_row();
    }
    RowSum sum(p.coarse);
    for (int sweep = 0; sweep < sweeps; ++sweep) rows = smoothed(graph, is_kept, rows, sum);
    store_rows(rows, p);
    store_transpose(p);
    return {std::move(p), std::move(voronoi.owner), std::move(voronoi.distance)};
}

}  // namespace weft
