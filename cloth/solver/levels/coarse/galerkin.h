#pragma once
// Coarse operators by Galerkin's product P^T W P, as springs between coarse nodes: the spring (i, j) with
// block K adds -(p_iI - p_jI) (p_iJ - p_jJ) K to the spring (I, J). The terms are found once; a step sums
// them.

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "cloth/equation/sparse/stencil.h"
#include "cloth/solver/levels/coarse/coarsening.h"
#include "engine/memory/shared_buffer.h"

namespace weft {

/// A spring between two nodes, first < second.
struct Link {
    std::uint32_t first, second;

    friend auto operator<=>(const Link&, const Link&) = default;
};

/// The fine link of each term by number, in rows of terms.
struct FineLinks {
    SharedBuffer<std::uint32_t> numbers;    ///< by term; empty when packed
    SharedBuffer<std::uint32_t> bases;      ///< packed: the least number of each row
    SharedBuffer<std::uint16_t> from_base;  ///< packed: each term's number less that base

    [[nodiscard]] bool is_packed() const noexcept { return !bases.empty() || !from_base.empty(); }
    [[nodiscard]] std::uint32_t of(std::uint32_t row, std::uint32_t term) const noexcept {
        return is_packed() ? bases[row] + from_base[term] : numbers[term];
    }
    /// Row r is terms [width * offsets[r], width * offsets[r + 1]). Terms of factor 0 may then name any link
    /// of their row. Does nothing if a row's numbers differ by more than 16 bits hold.
    void pack(std::span<const std::uint32_t> offsets, std::uint32_t width, std::span<const float> factors);
    [[nodiscard]] std::size_t bytes() const noexcept {
        return numbers.bytes() + bases.bytes() + from_base.bytes();
    }
};

/// The terms of each coarse spring: a factor and a spring of the finer level. Sums are taken 16 at a time, as
/// the rows of a Stencil are. Of each 1024 sums those with the most terms come first, so that lanes of a
/// group have about equally many.
struct GalerkinLists {
    SharedBuffer<std::uint32_t> group_slots;  ///< slots of group g: [group_slots[g], group_slots[g + 1])
    FineLinks fine_links;                     ///< by term, [slot * lanes + lane], a row for each group
    SharedBuffer<float> factors;              ///< by term; 0 where a lane has no more terms

    [[nodiscard]] std::uint32_t groups() const noexcept {
        return group_slots.empty() ? 0 : static_cast<std::uint32_t>(group_slots.size()) - 1;
    }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return group_slots.bytes() + fine_links.bytes() + factors.bytes();
    }
    void pack_fine_links() { fine_links.pack(group_slots.span(), Stencil::lanes, factors.span()); }
};

/// The links of a coarse level, which only the making of levels needs.
struct CoarseLinks {
    GalerkinLists lists;
    std::vector<Link> links;            ///< ascending
    std::vector<std::uint32_t> places;  ///< by link: the place of its sum, group * lanes + lane
    /// By place: the sum over fine links with a constant block, and 1.5 * 2^52 of its units, with which no
    /// smaller digit finds room; padded to whole groups.
    std::vector<double> constants;
    std::vector<float> shifts;
};

/// A term of a sum over constant blocks, rounded to the sum's unit: so few digits that the sum is exact. So
/// terms may come and go with pins, in any order, and leave the same sum.
[[nodiscard]] inline double exact_term(float term, float shift) noexcept {
    return (static_cast<double>(term) + static_cast<double>(shift)) - static_cast<double>(shift);
}

/// Row i minus row j of P, for a link (i, j): the entries that are not 0.
struct RowDifference {
    RowDifference(const Interpolation& p, const Link& link);

    struct Entry {
        std::uint32_t coarse;
        float value;
    };
    std::array<Entry, 2 * std::size_t{Interpolation::width}> entries;
    std::size_t size = 0;
};

/// Factors below this are left out: interpolation weights have no such precision.
constexpr float least_factor = 1e-4f;

/// body(coarse link, factor) for all terms of a fine link.
template <class Body>
void for_each_term(const Interpolation& p, const Link& link, const Body& body) {
    const RowDifference row(p, link);
    for (std::size_t a = 1; a < row.size; ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            const float factor = -row.entries[a].value * row.entries[b].value;
            if (!(std::abs(factor) > least_factor)) continue;
            const auto [first, second] = std::minmax(row.entries[a].coarse, row.entries[b].coarse);
            body(Link{first, second}, factor);
        }
    }
}

/// Links of a graph, ascending: each spring once.
[[nodiscard]] std::vector<Link> links_of(const SpringGraph& graph);

/// `links`: the springs of the fine level; constants[k]: the k-th one's constant block, or 0 (empty: none
/// has any).
[[nodiscard]] CoarseLinks make_coarse_links(const std::vector<Link>& links,
                                            const Interpolation& interpolation,
                                            std::span<const float> constants = {});

/// The graph of the coarse level: stiffness summed by the lists, lengths along the springs of the fine graph.
[[nodiscard]] SpringGraph make_coarse_graph(const SpringGraph& fine, const Coarsening& coarsening,
                                            const std::vector<Link>& fine_links, const CoarseLinks& coarse);

}  // namespace weft
