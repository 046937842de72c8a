#pragma once
// A graph of neighbours, laid out for vectors of any width: sliced ELLPACK (Monakov, Lokhmotov, Avetisyan
// 2010).
//
// Nodes are taken in groups of 16 lanes. A group has as many slots as its best-connected node has neighbours;
// a slot holds, lane by lane, one neighbour of each, in the order of their rows. A node names itself in the
// slots that it does not need, where all coefficients must be 0. Lanes past the last node name that one.
//
// Where the nodes of a group differ from their neighbours by the same few numbers, as in a grid, each of
// these differences has its slot. Kernels may then read a run of 16 consecutive rows; lanes that do not need
// the slot multiply theirs by 0.

#include <cstdint>
#include <span>

#include "engine/memory/shared_buffer.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

struct Stencil {
    static constexpr std::uint32_t lanes = 16;
    static_assert(block_size % lanes == 0, "a block is whole groups");
    static constexpr std::uint32_t no_run = ~0u;

    /// n, rounded up to whole groups.
    static constexpr std::uint32_t whole_groups(std::uint32_t n) { return (n + lanes - 1) / lanes * lanes; }

    /// The order of a group's slots: by the differences between nodes and neighbours, if these are few; or
    /// the order of the rows.
    enum class Order { by_difference, as_given };

    Stencil() = default;
    /// From compressed rows: the neighbours of node i are neighbours[offsets[i] .. offsets[i + 1]).
    Stencil(std::span<const std::uint32_t> offsets, std::span<const std::uint32_t> neighbours,
            Order order = Order::by_difference);

    std::uint32_t nodes = 0;
    SharedBuffer<std::uint32_t> group_slots;  ///< slots of group g: [group_slots[g], group_slots[g + 1])
    SharedBuffer<std::uint32_t> neighbours;   ///< [slot * lanes + lane]
    SharedBuffer<std::uint32_t> runs;         ///< of each slot: the first row of its run, or no_run
    SharedBuffer<std::uint16_t> slot_of;  ///< of each half-edge of the rows: its slot, counted in its group

    [[nodiscard]] std::uint32_t groups() const noexcept { return (nodes + lanes - 1) / lanes; }
    [[nodiscard]] std::uint32_t slots() const noexcept {
        return group_slots.empty() ? 0 : group_slots[groups()];
    }
    /// Half-edge e of a node: its slot * lanes + lane.
    [[nodiscard]] std::uint32_t entry(std::uint32_t node, std::size_t e) const noexcept {
        return (group_slots[node / lanes] + slot_of[e]) * lanes + node % lanes;
    }
    /// The group that a slot belongs to, by bisection.
    [[nodiscard]] std::uint32_t group_of(std::uint32_t slot) const noexcept;
    /// The node whose neighbour a slot holds in a lane.
    [[nodiscard]] std::uint32_t node_of(std::uint32_t slot, std::uint32_t lane) const noexcept;
    /// visit(list) for each of the stencil's lists.
    template <class Self, class Visit>
    static void for_each_list(Self& self, Visit& visit) {
        visit(self.group_slots);
        visit(self.neighbours);
        visit(self.runs);
        visit(self.slot_of);
    }
    /// Whether all indices in lists that were read are in range, for so many nodes and half-edges.
    [[nodiscard]] bool is_sound(std::uint32_t node_count, std::size_t half_edges) const;
    [[nodiscard]] std::size_t bytes() const noexcept {
        return group_slots.bytes() + neighbours.bytes() + runs.bytes() + slot_of.bytes();
    }
};

/// Values of a slot are stored as `arrays` arrays of 16. The index of lane `lane` in array k of the slot.
constexpr std::size_t lane_index(std::uint32_t entry, std::uint32_t k, std::uint32_t arrays) {
    const std::uint32_t slot = entry / Stencil::lanes, lane = entry % Stencil::lanes;
    return (std::size_t{slot} * arrays + k) * Stencil::lanes + lane;
}

}  // namespace weft
