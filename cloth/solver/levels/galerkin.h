#pragma once
// Coarse operators by Galerkin's product P^T W P, as springs between coarse nodes: the spring (i, j) with
// block K adds -(p_iI - p_jI) (p_iJ - p_jJ) K to the spring (I, J). The terms are found once; a step sums
// them.

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "cloth/equation/sparse/stencil.h"
#include "cloth/solver/levels/coarsening.h"
#include "engine/memory/aligned_buffer.h"
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
/// the rows of a Stencil are. Of each 256 sums those with the most terms come first, so that the lanes of a
/// group have about equally many.
struct GalerkinLists {
    /// Terms of fine links whose blocks are constant multiples of the identity.
    struct Constants {
        SharedBuffer<std::uint32_t> offsets;  ///< terms of link k: [offsets[k], offsets[k + 1])
        FineLinks fine_links;                 ///< by term, in these rows
        SharedBuffer<float> factors;
        AlignedBuffer<float> sums;  ///< by place: the sum of its terms, over constant_scale()

        [[nodiscard]] std::size_t bytes() const noexcept {
            return offsets.bytes() + fine_links.bytes() + factors.bytes() + sums.bytes();
        }
    } constants;

    SharedBuffer<Link> links;                 ///< of the coarse level, ascending
    SharedBuffer<std::uint32_t> places;       ///< by link: the place of its sum, group * lanes + lane
    SharedBuffer<std::uint32_t> group_slots;  ///< slots of group g: [group_slots[g], group_slots[g + 1])
    FineLinks fine_links;                     ///< by term, [slot * lanes + lane], a row for each group
    SharedBuffer<float> factors;              ///< by term; 0 where a lane has no more terms

    [[nodiscard]] std::uint32_t groups() const noexcept {
        return (static_cast<std::uint32_t>(links.size()) + Stencil::lanes - 1) / Stencil::lanes;
    }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return links.bytes() + places.bytes() + group_slots.bytes() + fine_links.bytes() + factors.bytes() +
               constants.bytes();
    }
    void pack_fine_links();
};

/// Links of a graph, ascending: each spring once.
[[nodiscard]] std::vector<Link> links_of(const SpringGraph& graph);

/// `links`: the springs of the fine level; is_constant[k]: whether the k-th has a constant block (empty:
/// none).
[[nodiscard]] GalerkinLists make_galerkin_lists(const std::vector<Link>& links,
                                                const Interpolation& interpolation,
                                                const std::vector<bool>& is_constant = {});

/// The graph of these links, without stiffnesses and lengths.
[[nodiscard]] SpringGraph graph_between(std::span<const Link> links, std::uint32_t nodes);

/// The graph of the coarse level: stiffness summed by the lists, lengths along the springs of the fine graph.
[[nodiscard]] SpringGraph make_coarse_graph(const SpringGraph& fine, const Coarsening& coarsening,
                                            const std::vector<Link>& fine_links, const GalerkinLists& lists);

}  // namespace weft
