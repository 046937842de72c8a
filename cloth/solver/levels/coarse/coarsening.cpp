#include "cloth/solver/levels/coarse/coarsening.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "cloth/equation/sparse/stencil.h"

namespace weft {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// The nearest kept node of each node, along the springs.
struct Voronoi {
    std::vector<float> distance;
    std::vector<std::uint32_t> owner;  // a node of the fine graph
};

/// A distance and a number as one integer that sorts by distance first. Precondition: neither is below 0.
std::uint64_t packed(float distance, std::uint32_t number) {
    return std::uint64_t{std::bit_cast<std::uint32_t>(distance)} << 32 | number;
}

/// Claims for a source all nodes that are nearer to it than to their present owner. The result does not
/// depend on the order of visits, because sums along a path only grow.
class Claims {
  public:
    Claims(const SpringGraph& graph, Voronoi& voronoi)
        : graph_(graph), voronoi_(voronoi), waits_(graph.nodes()) {}

    void operator()(std::uint32_t source) {
        source_ = source;
        claimed_ = 0;
        queue_.clear();
        heap_.clear();
        reach(source, 0, [&](std::uint32_t node) { wait(node); });
        // In the order of arrival few nodes are mostly visited again. If many are, distance decides.
        for (std::size_t k = 0; k < queue_.size(); ++k) {
            if (k > 64 + 4 * claimed_) return go_by_distance(k);
            waits_[queue_[k]] = 0;
            go_on_from(queue_[k], [&](std::uint32_t node) { wait(node); });
        }
    }

  private:
    void wait(std::uint32_t node) {
        if (std::exchange(waits_[node], 1) == 0) queue_.push_back(node);
    }
    template <class Then>
    void reach(std::uint32_t node, float distance, const Then& then) {
        if (distance >= voronoi_.distance[node]) return;
        voronoi_.distance[node] = distance;
        if (std::exchange(voronoi_.owner[node], source_) != source_) ++claimed_;
        then(node);
    }
    template <class Then>
    void go_on_from(std::uint32_t node, const Then& then) {
        const float distance = voronoi_.distance[node];
        for (std::uint32_t e = graph_.offsets[node]; e < graph_.offsets[node + 1]; ++e)
            reach(graph_.neighbours[e], distance + graph_.lengths[e], then);
    }
    /// Visits the nearest node first (Dijkstra 1959), beginning with the waiting ones.
    void go_by_distance(std::size_t first) {
        const auto push = [&](std::uint32_t node) {
            heap_.push_back(packed(voronoi_.distance[node], node));
            std::ranges::push_heap(heap_, std::greater());
        };
        for (std::size_t k = first; k < queue_.size(); ++k) {
            waits_[queue_[k]] = 0;
            push(queue_[k]);
        }
        while (!heap_.empty()) {
            std::ranges::pop_heap(heap_, std::greater());
            const std::uint64_t nearest = heap_.back();
            heap_.pop_back();
            const auto node = static_cast<std::uint32_t>(nearest);
            if (nearest <= packed(voronoi_.distance[node], node)) go_on_from(node, push);
        }
    }

    const SpringGraph& graph_;
    Voronoi& voronoi_;
    std::uint32_t source_ = 0;
    std::size_t claimed_ = 0;
    std::vector<std::uint32_t> queue_;
    std::vector<std::uint8_t> waits_;  // by node: it is in the queue
    std::vector<std::uint64_t> heap_;
};

/// The number of nodes that each component keeps.
std::vector<std::uint32_t> wanted_of(const Components& components, float ratio, std::uint32_t most_direct) {
    std::vector<std::uint32_t> wanted(components.count());
    for (std::uint32_t c = 0; c < components.count(); ++c) {
        const std::uint32_t size = components.size(c);
        if (size > most_direct)
            wanted[c] = static_cast<std::uint32_t>(std::ceil(static_cast<float>(size) / ratio));
    }
    return wanted;
}

/// Finds the node farthest from the kept ones, the lower number first. Distances only fall, so the stored
/// farthest of each few nodes is a bound, and is looked up anew when it comes first.
class Farthest {
  public:
    /// Over the nodes for which `is_wanted(node)`.
    template <class IsWanted>
    Farthest(const std::vector<float>& distance, const IsWanted& is_wanted) : distance_(distance) {
        is_out_.resize(distance.size());
        for (std::uint32_t i = 0; i < distance.size(); ++i) is_out_[i] = is_wanted(i) ? 0 : 1;
        for (std::uint32_t begin = 0; begin < distance.size(); begin += few)
            if (const std::uint64_t farthest = farthest_from(begin); farthest > 0) heap_.push_back(farthest);
        std::ranges::make_heap(heap_);
    }
    /// Returns nothing when no node is left.
    [[nodiscard]] std::optional<std::uint32_t> next() {
        while (!heap_.empty()) {
            const std::uint64_t known = heap_.front(), now = farthest_from(begin_of(known));
            if (now == known) return node_of(known);
            replace_first(now);
        }
        return std::nullopt;
    }
    void leave_out(std::uint32_t node) { is_out_[node] = 1; }

  private:
    static constexpr std::uint32_t few = 16;

    static std::uint32_t node_of(std::uint64_t pair) { return ~static_cast<std::uint32_t>(pair); }
    static std::uint32_t begin_of(std::uint64_t pair) { return node_of(pair) / few * few; }
    /// 0 if all are left out. A packed node is never 0, because it has the number's complement.
    [[nodiscard]] std::uint64_t farthest_from(std::uint32_t begin) const {
        const auto end = static_cast<std::uint32_t>(std::min<std::size_t>(begin + few, distance_.size()));
        std::uint64_t farthest = 0;
        for (std::uint32_t i = begin; i < end; ++i)
            if (is_out_[i] == 0) farthest = std::max(farthest, packed(distance_[i], ~i));
        return farthest;
    }
    /// Replaces the heap's top by a smaller or equal key; 0 pops it.
    void replace_first(std::uint64_t pair) {
        if (pair == 0) {
            pair = heap_.back();
            heap_.pop_back();
            if (heap_.empty()) return;
        }
        std::size_t at = 0;
        for (;;) {
            std::size_t larger = 2 * at + 1;
            if (larger >= heap_.size()) break;
            if (larger + 1 < heap_.size() && heap_[larger + 1] > heap_[larger]) ++larger;
            if (heap_[larger] <= pair) break;
            heap_[at] = heap_[larger];
            at = larger;
        }
        heap_[at] = pair;
    }

    const std::vector<float>& distance_;
    std::vector<std::uint8_t> is_out_;
    std::vector<std::uint64_t> heap_;
};

/// Farthest-point sampling (Gonzalez 1985) in each component by itself: the next node is the farthest from
/// those before. Nodes that no kept node reaches come first.
Voronoi sample_farthest(const SpringGraph& graph, const Components& components,
                        std::vector<std::uint32_t> wanted, std::vector<std::uint32_t>& kept) {
    Voronoi voronoi{std::vector<float>(graph.nodes(), infinity),
                    std::vector<std::uint32_t>(graph.nodes(), 0)};
    Claims claim(graph, voronoi);
    const auto keep = [&](std::uint32_t node) {
        kept.push_back(node);
        claim(node);
    };
    const auto has_part = [&](std::uint32_t node, const std::vector<std::uint32_t>& of_components) {
        return graph.degree(node) > 0 && of_components[components.of_node[node]] > 0;
    };
    std::vector<std::uint32_t> left = wanted;
    for (std::uint32_t i = 0; i < graph.nodes(); ++i) {
        if (!has_part(i, wanted) || voronoi.distance[i] < infinity) continue;
        std::uint32_t& left_here = left[components.of_node[i]];
        if (left_here > 0) --left_here;
        keep(i);
    }
    Farthest farthest(voronoi.distance,
                      [&](std::uint32_t i) { return has_part(i, left) && voronoi.owner[i] != i; });
    while (const std::optional<std::uint32_t> node = farthest.next()) {
        std::uint32_t& left_here = left[components.of_node[*node]];
        farthest.leave_out(*node);
        if (left_here == 0) continue;
        --left_here;
        keep(*node);
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

/// Sums a row; its nodes stay in the order in which they came.
class RowSum {
  public:
    explicit RowSum(std::uint32_t coarse) : places_(coarse, none), row_(coarse) {}

    void add(std::span<const Weight> weights, float factor) {
        std::uint32_t* const places = places_.data();
        Weight* const row = row_.data();
        std::uint32_t size = size_;
        for (const Weight& w : weights) {
            const std::uint32_t place = places[w.coarse];
            if (place == none) {
                places[w.coarse] = size;
                row[size++] = {w.coarse, factor * w.value};
            } else {
                row[place].value += factor * w.value;
            }
        }
        size_ = size;
    }
    /// Appends the row over `divisor`, and begins another.
    void move_to(Rows& rows, float divisor) {
        const std::size_t begin = rows.weights.size();
        rows.weights.resize(begin + size_);
        for (std::uint32_t k = 0; k < size_; ++k) {
            rows.weights[begin + k] = {row_[k].coarse, row_[k].value / divisor};
            places_[row_[k].coarse] = none;
        }
        rows.end_row();
        size_ = 0;
    }

  private:
    static constexpr std::uint32_t none = ~0u;
    std::vector<std::uint32_t> places_;  // by coarse node: its place in the row
    std::vector<Weight> row_;            // the first size_ are in use
    std::uint32_t size_ = 0;
};

/// Jacobi sweeps of the springs' Laplacian on the weights; kept nodes hold theirs.
class Smoothing {
  public:
    Smoothing(const SpringGraph& graph, const std::vector<bool>& is_kept, std::uint32_t coarse)
        : graph_(graph), is_kept_(is_kept), sum_(coarse), stiffness_(graph.nodes()) {
        for (std::uint32_t i = 0; i < graph.nodes(); ++i)
            for (std::uint32_t e = graph.offsets[i]; e < graph.offsets[i + 1]; ++e)
                stiffness_[i] += graph.stiffness[e];
    }
    [[nodiscard]] Rows operator()(const Rows& rows) {
        Rows result;
        result.offsets.reserve(rows.offsets.size());
        result.weights.reserve(2 * rows.weights.size());
        for (std::uint32_t i = 0; i < graph_.nodes(); ++i) {
            if (is_held(i)) {
                const std::span<const Weight> row = rows.row(i);
                result.weights.insert(result.weights.end(), row.begin(), row.end());
                result.end_row();
                continue;
            }
            // A spring of stiffness 0 would only add weights of 0.
            for (std::uint32_t e = graph_.offsets[i]; e < graph_.offsets[i + 1]; ++e) {
                const float stiffness = graph_.stiffness[e];
                if (stiffness == 0) continue;
                sum_.add(rows.row(graph_.neighbours[e]), stiffness);
            }
            sum_.move_to(result, stiffness_[i]);
        }
        return result;
    }
    /// Whether sweeps leave the node's row as it is.
    [[nodiscard]] bool is_held(std::uint32_t node) const { return is_kept_[node] || stiffness_[node] == 0; }

  private:
    const SpringGraph& graph_;
    const std::vector<bool>& is_kept_;
    RowSum sum_;
    std::vector<float> stiffness_;  // by node: the sum of its springs'
};

/// Keeps the largest weights of each row, scaled to sum 1, ascending by node.
void store_rows(const Rows& rows, Interpolation& interpolation) {
    const auto is_before = [](const Weight& a, const Weight& b) {
        return a.value > b.value || (a.value == b.value && a.coarse < b.coarse);
    };
    for (std::uint32_t i = 0; i < interpolation.fine; ++i) {
        std::array<Weight, Interpolation::width> row;
        std::size_t size = 0;
        for (const Weight& w : rows.row(i)) {
            if (size == row.size() && !is_before(w, row.back())) continue;
            std::size_t at = size < row.size() ? size++ : size - 1;
            for (; at > 0 && is_before(w, row[at - 1]); --at) row[at] = row[at - 1];
            row[at] = w;
        }
        const std::span<Weight> largest = std::span(row).first(size);
        for (std::size_t k = 1; k < size; ++k)  // not by std::sort, where compilers see room for more of them
            for (std::size_t at = k; at > 0 && row[at].coarse < row[at - 1].coarse; --at)
                std::swap(row[at], row[at - 1]);
        float sum = 0;
        for (const Weight& w : largest) sum += w.value;
        for (std::size_t k = 0; k < size; ++k) {
            interpolation.nodes[Interpolation::width * i + k] = largest[k].coarse;
            interpolation.weights[Interpolation::width * i + k] = largest[k].value / sum;
        }
    }
}

}  // namespace

void store_transpose(Interpolation& p) {
    std::uint32_t used = 0;
    for (const float weight : p.weights.span()) used += weight != 0;
    p.offsets = AlignedBuffer<std::uint32_t>(p.coarse + 1);
    p.entries = AlignedBuffer<std::uint32_t>(used);
    for (std::size_t e = 0; e < p.weights.size(); ++e) {
        if (p.weights[e] != 0) ++p.offsets[p.nodes[e] + 1];
    }
    for (std::uint32_t c = 0; c < p.coarse; ++c) p.offsets[c + 1] += p.offsets[c];
    std::vector<std::uint32_t> next(p.offsets.data(), p.offsets.data() + p.coarse);
    for (std::size_t e = 0; e < p.weights.size(); ++e) {
        if (p.weights[e] != 0) p.entries[next[p.nodes[e]]++] = static_cast<std::uint32_t>(e);
    }
}

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
        if (voronoi.distance[i] != infinity) {  // else no kept node reaches it
            voronoi.owner[i] = coarse_of[voronoi.owner[i]];
            rows.weights.push_back({voronoi.owner[i], 1.0f});
        }
        rows.end_row();
    }
    Smoothing smoothed(graph, is_kept, p.coarse);
    for (int sweep = 0; sweep < sweeps; ++sweep) rows = smoothed(rows);
    store_rows(rows, p);
    store_transpose(p);
    return {std::move(p), std::move(voronoi.owner), std::move(voronoi.distance)};
}

}  // namespace weft
