#include "cloth/solvers/multigrid/galerkin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "engine/parallel_blocks.h"

namespace weft {

namespace {

/// Factors below this are left out: interpolation weights have no such precision.
constexpr float least_factor = 1e-4f;

struct Difference {
    std::uint32_t coarse;
    float value;
};

struct RowDifference {
    std::array<Difference, 2 * Interpolation::width> entries;
    std::size_t size = 0;
    [[nodiscard]] auto begin() { return entries.begin(); }
    [[nodiscard]] auto end() { return entries.begin() + size; }
};

/// Row i minus row j of P, entries that are not 0.
RowDifference row_difference(const Interpolation& p, const Link& link) {
    RowDifference result;
    for (const auto& [node, sign] : {std::pair(link.first, 1.0f), std::pair(link.second, -1.0f)}) {
        for (std::uint32_t e = Interpolation::width * node; e < Interpolation::width * (node + 1); ++e) {
            if (p.weights[e] == 0) continue;
            const auto at = std::ranges::find(result, p.nodes[e], &Difference::coarse);
            if (at == result.end())
                result.entries[result.size++] = {p.nodes[e], sign * p.weights[e]};
            else
                at->value += sign * p.weights[e];
        }
    }
    return result;
}

/// Links of each node, in compressed rows.
struct Incidence {
    std::vector<std::uint32_t> offsets, links;
};
Incidence incidence(std::span<const Link> links, std::uint32_t nodes) {
    Incidence result{std::vector<std::uint32_t>(nodes + 1), std::vector<std::uint32_t>(2 * links.size())};
    for (const Link& link : links) {
        ++result.offsets[link.first + 1];
        ++result.offsets[link.second + 1];
    }
    for (std::uint32_t i = 0; i < nodes; ++i) result.offsets[i + 1] += result.offsets[i];
    std::vector<std::uint32_t> next(result.offsets.begin(), result.offsets.end() - 1);
    for (std::uint32_t k = 0; k < links.size(); ++k) {
        result.links[next[links[k].first]++] = k;
        result.links[next[links[k].second]++] = k;
    }
    return result;
}

struct Term {
    std::uint32_t first, second;  // nodes of the coarse link
    std::uint32_t fine_link;
    float factor;
};

/// All terms, those of each link by fine links, ascending.
std::vector<Term> terms_of(const std::vector<Link>& links, const Interpolation& p) {
    std::vector<Term> terms;
    terms.reserve(8 * links.size());
    for (std::uint32_t link = 0; link < links.size(); ++link) {
        RowDifference row = row_difference(p, links[link]);
        for (const Difference& own : row) {
            for (const Difference& other : row) {
                const float factor = -own.value * other.value;
                if (other.coarse > own.coarse && std::abs(factor) > least_factor)
                    terms.push_back({own.coarse, other.coarse, link, factor});
            }
        }
    }
    return terms;
}

/// By a number below `count`; those of one number stay in order.
template <class Number>
std::vector<Term> sorted_by(const Number& number, const std::vector<Term>& terms, std::uint32_t count) {
    std::vector<std::size_t> next(count + std::size_t{1});
    for (const Term& term : terms) ++next[number(term) + std::size_t{1}];
    for (std::uint32_t c = 0; c < count; ++c) next[c + 1] += next[c];
    std::vector<Term> sorted(terms.size());
    for (const Term& term : terms) sorted[next[number(term)]++] = term;
    return sorted;
}

/// Lists as they grow, link by link.
struct GrowingLists {
    std::vector<Link> links;
    std::vector<std::uint32_t> offsets{0};  // terms of link k: [offsets[k], offsets[k + 1])
    std::vector<std::uint32_t> fine_links;
    std::vector<float> factors;
    struct {
        std::vector<std::uint32_t> offsets{0}, fine_links;
        std::vector<float> factors;
    } constants;

    void add(const Term& term, bool is_constant) {
        if (links.empty() || links.back().first != term.first || links.back().second != term.second) {
            links.push_back({term.first, term.second});
            offsets.push_back(offsets.back());
            constants.offsets.push_back(constants.offsets.back());
        }
        if (is_constant) {
            constants.fine_links.push_back(term.fine_link);
            constants.factors.push_back(term.factor);
            ++constants.offsets.back();
            return;
        }
        fine_links.push_back(term.fine_link);
        factors.push_back(term.factor);
        ++offsets.back();
    }
    [[nodiscard]] std::uint32_t terms(std::uint32_t link) const { return offsets[link + 1] - offsets[link]; }
};

/// Links by the places of their sums.
std::vector<std::uint32_t> ordered_for_lanes(const GrowingLists& lists) {
    std::vector<std::uint32_t> order(lists.links.size());
    std::iota(order.begin(), order.end(), 0u);
    for (std::size_t begin = 0; begin < order.size(); begin += block_size) {
        const std::span block =
            std::span(order).subspan(begin).first(std::min<std::size_t>(block_size, order.size() - begin));
        std::ranges::stable_sort(block, std::greater(),
                                 [&](std::uint32_t link) { return lists.terms(link); });
    }
    return order;
}

GalerkinLists in_groups(const GrowingLists& grown) {
    constexpr std::uint32_t lanes = Stencil::lanes;
    const std::vector<std::uint32_t> order = ordered_for_lanes(grown);
    GalerkinLists lists;
    lists.links = SharedBuffer<Link>(grown.links);
    lists.constants.offsets = SharedBuffer<std::uint32_t>(grown.constants.offsets);
    lists.constants.fine_links = SharedBuffer<std::uint32_t>(grown.constants.fine_links);
    lists.constants.factors = SharedBuffer<float>(grown.constants.factors);
    lists.constants.sums = AlignedBuffer<float>(lists.groups() * lanes);
    lists.places = SharedBuffer<std::uint32_t>(order.size());
    lists.group_slots = SharedBuffer<std::uint32_t>(lists.groups() + 1);
    for (std::uint32_t place = 0; place < order.size(); ++place) {
        lists.places[order[place]] = place;
        std::uint32_t& slots = lists.group_slots[place / lanes + 1];
        slots = std::max(slots, grown.terms(order[place]));
    }
    for (std::uint32_t g = 0; g < lists.groups(); ++g) lists.group_slots[g + 1] += lists.group_slots[g];

    const std::size_t entries = std::size_t{lists.group_slots[lists.groups()]} * lanes;
    lists.fine_links = SharedBuffer<std::uint32_t>(entries);
    lists.factors = SharedBuffer<float>(entries);
    for (std::uint32_t place = 0; place < order.size(); ++place) {
        const std::uint32_t begin = grown.offsets[order[place]], group = place / lanes;
        const std::uint32_t terms = grown.terms(order[place]);
        for (std::uint32_t s = lists.group_slots[group]; s < lists.group_slots[group + 1]; ++s) {
            const std::uint32_t t = s - lists.group_slots[group], entry = s * lanes + place % lanes;
            if (terms > 0) lists.fine_links[entry] = grown.fine_links[begin + std::min(t, terms - 1)];
            lists.factors[entry] = t < terms ? grown.factors[begin + t] : 0;
        }
    }
    return lists;
}

}  // namespace

std::vector<Link> links_of(const SpringGraph& graph) {
    std::vector<Link> links;
    for (std::uint32_t i = 0; i < graph.nodes(); ++i) {
        for (std::uint32_t e = graph.offsets[i]; e < graph.offsets[i + 1]; ++e) {
            if (graph.neighbours[e] > i) links.push_back({i, graph.neighbours[e]});
        }
    }
    return links;
}

GalerkinLists make_galerkin_lists(const std::vector<Link>& links, const Interpolation& p,
                                  const std::vector<bool>& is_constant) {
    const auto first = [](const Term& term) { return term.first; };
    const auto second = [](const Term& term) { return term.second; };
    const std::vector<Term> terms =
        sorted_by(first, sorted_by(second, terms_of(links, p), p.coarse), p.coarse);
    GrowingLists lists;
    for (const Term& term : terms) lists.add(term, !is_constant.empty() && is_constant[term.fine_link]);
    return in_groups(lists);
}

SpringGraph make_coarse_graph(const SpringGraph& fine, const Coarsening& coarsening,
                              const std::vector<Link>& fine_links, const GalerkinLists& lists) {
    std::vector<float> fine_stiffness;
    std::vector<float> length(lists.links.size(), std::numeric_limits<float>::infinity());
    const auto link_between = [&](std::uint32_t a, std::uint32_t b) {
        const std::pair<std::uint32_t, std::uint32_t> wanted = std::minmax(a, b);
        const auto at = std::ranges::lower_bound(
            lists.links, wanted, {}, [](const Link& link) { return std::pair(link.first, link.second); });
        const bool found =
            at != lists.links.end() && at->first == wanted.first && at->second == wanted.second;
        return found ? at - lists.links.begin() : -1;
    };
    std::uint32_t e_first = 0;
    for (const Link& link : fine_links) {
        e_first = fine.offsets[link.first];
        while (fine.neighbours[e_first] != link.second) ++e_first;
        fine_stiffness.push_back(fine.stiffness[e_first]);
        const std::uint32_t a = coarsening.owner[link.first], b = coarsening.owner[link.second];
        if (a == b) continue;
        const auto at = link_between(a, b);
        if (at < 0) continue;
        float& shortest = length[static_cast<std::size_t>(at)];
        shortest = std::min(shortest, coarsening.distance[link.first] + fine.lengths[e_first] +
                                          coarsening.distance[link.second]);
    }

    const std::uint32_t nodes = coarsening.interpolation.coarse;
    SpringGraph graph{.offsets = std::vector<std::uint32_t>(nodes + 1),
                      .neighbours = std::vector<std::uint32_t>(2 * lists.links.size()),
                      .stiffness = std::vector<float>(2 * lists.links.size()),
                      .lengths = std::vector<float>(2 * lists.links.size())};
    const Incidence touching = incidence(lists.links, nodes);
    graph.offsets = touching.offsets;
    for (std::uint32_t i = 0; i < nodes; ++i) {
        for (std::uint32_t e = graph.offsets[i]; e < graph.offsets[i + 1]; ++e) {
            const std::uint32_t k = touching.links[e];
            const Link& link = lists.links[k];
            float stiffness = 0;
            const std::uint32_t group = lists.places[k] / Stencil::lanes,
                                lane = lists.places[k] % Stencil::lanes;
            for (std::uint32_t s = lists.group_slots[group]; s < lists.group_slots[group + 1]; ++s) {
                const std::uint32_t term = s * Stencil::lanes + lane;
                stiffness += lists.factors[term] * fine_stiffness[lists.fine_links[term]];
            }
            graph.neighbours[e] = link.first == i ? link.second : link.first;
            graph.stiffness[e] = std::max(stiffness, 0.0f);
            graph.lengths[e] = length[k];
        }
    }
    return graph;
}

}  // namespace weft
