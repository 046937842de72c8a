#include "cloth/solver/levels/coarse/galerkin.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "engine/threads/parallel_blocks.h"

namespace weft {

namespace {

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

/// A term of a coarse link, the first node of which is known.
struct Term {
    std::uint32_t second, fine_link;
    float factor;
};

/// All terms by first nodes, those of each by fine links, ascending.
struct Terms {
    std::vector<std::size_t> offsets;
    std::vector<Term> terms;
};
Terms terms_of(const std::vector<Link>& links, const Interpolation& p) {
    Terms result;
    result.offsets.resize(p.coarse + std::size_t{1});
    for (std::uint32_t k = 0; k < links.size(); ++k)
        for_each_term(p, links[k],
                      [&](const Link& link, float) { ++result.offsets[link.first + std::size_t{1}]; });
    for (std::uint32_t c = 0; c < p.coarse; ++c) result.offsets[c + 1] += result.offsets[c];
    result.terms.resize(result.offsets.back());
    std::vector<std::size_t> next(result.offsets.begin(), result.offsets.end() - 1);
    for (std::uint32_t k = 0; k < links.size(); ++k)
        for_each_term(p, links[k], [&](const Link& link, float factor) {
            result.terms[next[link.first]++] = {link.second, k, factor};
        });
    return result;
}

/// A stable sort of the terms of one first node by their second nodes.
class SortBySecond {
  public:
    explicit SortBySecond(std::uint32_t coarse) : counts_(coarse) {}

    std::span<const Term> operator()(std::span<const Term> terms) {
        seconds_.clear();
        for (const Term& term : terms)
            if (counts_[term.second]++ == 0) seconds_.push_back(term.second);
        std::ranges::sort(seconds_);
        std::uint32_t begin = 0;
        for (const std::uint32_t second : seconds_) begin += std::exchange(counts_[second], begin);
        sorted_.resize(terms.size());
        for (const Term& term : terms) sorted_[counts_[term.second]++] = term;
        for (const std::uint32_t second : seconds_) counts_[second] = 0;
        return sorted_;
    }

  private:
    std::vector<std::uint32_t> counts_, seconds_;
    std::vector<Term> sorted_;
};

/// Lists as they grow, link by link.
struct GrowingLists {
    std::vector<Link> links;
    std::vector<std::uint32_t> offsets{0};  // terms of link k: [offsets[k], offsets[k + 1])
    std::vector<std::uint32_t> fine_links;
    std::vector<float> factors;
    std::vector<double> constants;  // by link
    std::vector<float> shifts;

    /// Adds a link with all of its terms, of fine links of which some have constant blocks.
    void add(const Link& link, std::span<const Term> terms, std::span<const float> blocks) {
        links.push_back(link);
        std::uint32_t count = 0;
        float most = 0;
        for (const Term& term : terms) {
            const float block = blocks.empty() ? 0 : blocks[term.fine_link];
            if (block != 0) {
                ++count;
                most = std::max(most, std::abs(term.factor * block));
            } else {
                fine_links.push_back(term.fine_link);
                factors.push_back(term.factor);
            }
        }
        offsets.push_back(static_cast<std::uint32_t>(factors.size()));
        // Each of the terms is below 2^51 units, and their sum below 2^52.
        shifts.push_back(std::isnormal(most) ? std::ldexp(1.5f, std::ilogb(most) + 1 + std::bit_width(count))
                                             : 0);
        double sum = 0;
        for (const Term& term : terms)
            if (!blocks.empty() && blocks[term.fine_link] != 0)
                sum += exact_term(term.factor * blocks[term.fine_link], shifts.back());
        constants.push_back(sum);
    }
    [[nodiscard]] std::uint32_t terms(std::uint32_t link) const { return offsets[link + 1] - offsets[link]; }
};

/// The number of links that are sorted by the lengths of their sums: of a sheet, 4 % of the terms are padding
/// (256: 13 %), and the numbers of a group's fine links still differ by less than 16 bits hold.
constexpr std::size_t sorted_together = 1024;

/// Links in the order of their sums' places.
std::vector<std::uint32_t> ordered_for_lanes(const GrowingLists& lists) {
    std::vector<std::uint32_t> order(lists.links.size());
    std::iota(order.begin(), order.end(), 0u);
    for (std::size_t begin = 0; begin < order.size(); begin += sorted_together) {
        const std::span block = std::span(order).subspan(begin).first(
            std::min<std::size_t>(sorted_together, order.size() - begin));
        std::ranges::stable_sort(block, std::greater(),
                                 [&](std::uint32_t link) { return lists.terms(link); });
    }
    return order;
}

CoarseLinks in_groups(GrowingLists&& grown) {
    constexpr std::uint32_t lanes = Stencil::lanes;
    const std::vector<std::uint32_t> order = ordered_for_lanes(grown);
    CoarseLinks result;
    GalerkinLists& lists = result.lists;
    const std::uint32_t groups = (static_cast<std::uint32_t>(order.size()) + lanes - 1) / lanes;
    result.constants.resize(std::size_t{groups} * lanes);
    result.shifts.resize(result.constants.size());
    result.places.resize(order.size());
    lists.group_slots = SharedBuffer<std::uint32_t>(groups + std::size_t{1});
    for (std::uint32_t place = 0; place < order.size(); ++place) {
        result.places[order[place]] = place;
        result.constants[place] = grown.constants[order[place]];
        result.shifts[place] = grown.shifts[order[place]];
        std::uint32_t& slots = lists.group_slots[place / lanes + 1];
        slots = std::max(slots, grown.terms(order[place]));
    }
    for (std::uint32_t g = 0; g < groups; ++g) lists.group_slots[g + 1] += lists.group_slots[g];

    const std::size_t entries = std::size_t{lists.group_slots[groups]} * lanes;
    lists.fine_links.numbers = SharedBuffer<std::uint32_t>(entries);
    lists.factors = SharedBuffer<float>(entries);
    for (std::uint32_t place = 0; place < order.size(); ++place) {
        const std::uint32_t begin = grown.offsets[order[place]], group = place / lanes;
        const std::uint32_t terms = grown.terms(order[place]);
        for (std::uint32_t s = lists.group_slots[group]; s < lists.group_slots[group + 1]; ++s) {
            const std::uint32_t t = s - lists.group_slots[group], entry = s * lanes + place % lanes;
            if (terms > 0) lists.fine_links.numbers[entry] = grown.fine_links[begin + std::min(t, terms - 1)];
            lists.factors[entry] = t < terms ? grown.factors[begin + t] : 0;
        }
    }
    result.links = std::move(grown.links);
    return result;
}

}  // namespace

RowDifference::RowDifference(const Interpolation& p, const Link& link) {
    for (const auto& [node, sign] : {std::pair(link.first, 1.0f), std::pair(link.second, -1.0f)}) {
        for (std::uint32_t e = Interpolation::width * node; e < Interpolation::width * (node + 1); ++e) {
            const float weight = p.weights[e];
            if (weight == 0) continue;
            const std::uint32_t coarse = p.nodes[e];
            std::size_t at = 0;
            while (at < size && entries[at].coarse != coarse) ++at;
            if (at == size)
                entries[size++] = {coarse, sign * weight};
            else
                entries[at].value += sign * weight;
        }
    }
}

void FineLinks::pack(std::span<const std::uint32_t> offsets, std::uint32_t width,
                     std::span<const float> factors) {
    constexpr std::uint32_t far = std::numeric_limits<std::uint16_t>::max();
    const std::size_t rows = offsets.empty() ? 0 : offsets.size() - 1;
    SharedBuffer<std::uint32_t> least(rows);
    SharedBuffer<std::uint16_t> from_least(numbers.size());
    for (std::size_t row = 0; row < rows; ++row) {
        const std::uint32_t begin = offsets[row] * width, end = offsets[row + 1] * width;
        std::uint32_t base = ~0u, last = 0;
        for (std::uint32_t t = begin; t < end; ++t) {
            if (factors[t] == 0) continue;
            base = std::min(base, numbers[t]);
            last = std::max(last, numbers[t]);
        }
        if (base > last) base = last = 0;
        if (last - base > far) return;
        least[row] = base;
        for (std::uint32_t t = begin; t < end; ++t)
            from_least[t] = static_cast<std::uint16_t>(std::clamp(numbers[t], base, last) - base);
    }
    bases = std::move(least);
    from_base = std::move(from_least);
    numbers = {};
}

std::vector<Link> links_of(const SpringGraph& graph) {
    std::vector<Link> links;
    for (std::uint32_t i = 0; i < graph.nodes(); ++i) {
        for (std::uint32_t e = graph.offsets[i]; e < graph.offsets[i + 1]; ++e) {
            if (graph.neighbours[e] > i) links.push_back({i, graph.neighbours[e]});
        }
    }
    return links;
}

CoarseLinks make_coarse_links(const std::vector<Link>& links, const Interpolation& p,
                              std::span<const float> constants) {
    GrowingLists lists;
    const Terms terms = terms_of(links, p);
    lists.fine_links.reserve(terms.terms.size());
    lists.factors.reserve(terms.terms.size());
    SortBySecond sorted(p.coarse);
    for (std::uint32_t first = 0; first < p.coarse; ++first) {
        const std::size_t begin = terms.offsets[first], count = terms.offsets[first + std::size_t{1}] - begin;
        std::span<const Term> left = sorted(std::span(terms.terms).subspan(begin, count));
        while (!left.empty()) {
            const std::uint32_t second = left.front().second;
            const auto end = std::ranges::find_if(left, [&](const Term& t) { return t.second != second; });
            const auto size = static_cast<std::size_t>(end - left.begin());
            lists.add({first, second}, left.first(size), constants);
            left = left.subspan(size);
        }
    }
    return in_groups(std::move(lists));
}

SpringGraph make_coarse_graph(const SpringGraph& fine, const Coarsening& coarsening,
                              const std::vector<Link>& fine_links, const CoarseLinks& links) {
    const GalerkinLists& lists = links.lists;
    const std::uint32_t nodes = coarsening.interpolation.coarse;
    std::vector<std::uint32_t> starts(nodes + std::size_t{1});  // by first node: its first link
    for (const Link& link : links.links) ++starts[link.first + std::size_t{1}];
    for (std::uint32_t i = 0; i < nodes; ++i) starts[i + 1] += starts[i];

    std::vector<float> fine_stiffness(fine_links.size());
    std::vector<float> length(links.links.size(), std::numeric_limits<float>::infinity());
    std::size_t number = 0;
    for (std::uint32_t i = 0; i < fine.nodes(); ++i) {
        for (std::uint32_t e = fine.offsets[i]; e < fine.offsets[i + 1]; ++e) {
            const std::uint32_t j = fine.neighbours[e];
            if (j <= i) continue;
            fine_stiffness[number++] = fine.stiffness[e];
            const auto [a, b] = std::minmax(coarsening.owner[i], coarsening.owner[j]);
            if (a == b) continue;
            std::uint32_t k = starts[a];
            while (k < starts[a + 1] && links.links[k].second < b) ++k;
            if (k == starts[a + 1] || links.links[k].second != b) continue;
            length[k] =
                std::min(length[k], coarsening.distance[i] + fine.lengths[e] + coarsening.distance[j]);
        }
    }

    SpringGraph graph{.offsets = std::vector<std::uint32_t>(nodes + 1),
                      .neighbours = std::vector<std::uint32_t>(2 * links.links.size()),
                      .stiffness = std::vector<float>(2 * links.links.size()),
                      .lengths = std::vector<float>(2 * links.links.size())};
    const Incidence touching = incidence(links.links, nodes);
    graph.offsets = touching.offsets;
    for (std::uint32_t i = 0; i < nodes; ++i) {
        for (std::uint32_t e = graph.offsets[i]; e < graph.offsets[i + 1]; ++e) {
            const std::uint32_t k = touching.links[e];
            const Link& link = links.links[k];
            float stiffness = 0;
            const std::uint32_t group = links.places[k] / Stencil::lanes,
                                lane = links.places[k] % Stencil::lanes;
            for (std::uint32_t s = lists.group_slots[group]; s < lists.group_slots[group + 1]; ++s) {
                const std::uint32_t term = s * Stencil::lanes + lane;
                stiffness += lists.factors[term] * fine_stiffness[lists.fine_links.of(group, term)];
            }
            graph.neighbours[e] = link.first == i ? link.second : link.first;
            graph.stiffness[e] = std::max(stiffness, 0.0f);
            graph.lengths[e] = length[k];
        }
    }
    return graph;
}

}  // namespace weft
