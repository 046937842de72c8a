#pragma once
// Coarse operators by Galerkin's product P^T W P, as springs between coarse nodes: the spring (i, j) with
// block K adds -(p_iI - p_jI) (p_iJ - p_jJ) K to the spring (I, J). The terms are found once; a step sums
// them.

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "cloth/solvers/multigrid/coarsening.h"
#include "cloth/system/sparse/stencil.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/memory/shared_buffer.h"

namespace weft {

/// A spring between two nodes, first < second.
struct Link {
    std::uint32_t first, second;

    friend auto operator<=>(const Link&, const Link&) = default;
};

/// The terms of each coarse spring: a factor and a spring of the finer level. Sums are taken 16 at a time, as
/// the rows of a Stencil are. Of each 256 sums those with the most terms come first, so that the lanes of a
/// group have about as many.
struct GalerkinLists {
    /// Terms of fine links whose blocks are a number times the identity, and never change: by coarse link,
    /// those of link k in [offsets[k], offsets[k + 1]).
    struct Constants {
        SharedBuffer<std::uint32_t> offsets, fine_links;
        SharedBuffer<float> factors;
        SharedBuffer<std::uint32_t> bases;  ///< packed, as those below, of each coarse link
        SharedBuffer<std::uint16_t> near_links;
        AlignedBuffer<float> sums;  ///< of each place: what the terms add up to, over constant_scale()

        [[nodiscard]] std::size_t bytes() const noexcept {
            return offsets.bytes() + fine_links.bytes() + factors.bytes() + bases.bytes() +
                   near_links.bytes() + sums.bytes();
        }
        /// The t-th term's, of coarse link k.
        [[nodiscard]] std::uint32_t fine_link(std::uint32_t k, std::uint32_t t) const noexcept {
            return near_links.empty() ? fine_links[t] : bases[k] + near_links[t];
        }
        void pack();
    } constants;

    SharedBuffer<Link> links;                 ///< of the coarse level, ascending
    SharedBuffer<std::uint32_t> places;       ///< of each link: which sum is its, group * lanes + lane
    SharedBuffer<std::uint32_t> group_slots;  ///< slots of group g: [group_slots[g], group_slots[g + 1])
    SharedBuffer<std::uint32_t> fine_links;   ///< of each term, [slot * lanes + lane]; none once packed
    SharedBuffer<float> factors;              ///< likewise; 0 where a lane has no more terms
    SharedBuffer<std::uint32_t> bases;        ///< packed: of each group the least of its terms' fine links,
    SharedBuffer<std::uint16_t> near_links;   ///< and by how much that of each term is more

    [[nodiscard]] std::uint32_t groups() const noexcept {
        return (static_cast<std::uint32_t>(links.size()) + Stencil::lanes - 1) / Stencil::lanes;
    }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return links.bytes() + places.bytes() + group_slots.bytes() + fine_links.bytes() + factors.bytes() +
               bases.bytes() + near_links.bytes() + constants.bytes();
    }
    /// Fine links by what they are from their group's least, unless one is too far.
    void pack();
};

/// Links of a graph, ascending: each spring once.
[[nodiscard]] std::vector<Link> links_of(const SpringGraph& graph);

/// `links`: the springs of the fine level; is_constant[k]: whether the k-th has a constant block (empty:
/// none).
[[nodiscard]] GalerkinLists make_galerkin_lists(const std::vector<Link>& links,
                                                const Interpolation& interpolation,
                                                const std::vector<bool>& is_constant = {});

/// Who is whose neighbour, without stiffnesses and lengths.
[[nodiscard]] SpringGraph graph_between(std::span<const Link> links, std::uint32_t nodes);

/// The graph of the coarse level: stiffness summed by the lists, lengths along the springs of the fine graph.
[[nodiscard]] SpringGraph make_coarse_graph(const SpringGraph& fine, const Coarsening& coarsening,
                                            const std::vector<Link>& fine_links, const GalerkinLists& lists);

}  // namespace weft
