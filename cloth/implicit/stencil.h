#pragma once
// Who is whose neighbour, laid out for vectors of any width: sliced ELLPACK (Monakov, Lokhmotov, Avetisyan
// 2010).
//
// Nodes are taken in groups of 16 lanes. A group has as many slots as its best-connected node has neighbours;
// a slot holds, lane by lane, one neighbour of each, in ascending order. Slots that a node, or a lane past
// the last node, does not need name some node all the same, mostly itself, and all coefficients there must be
// 0.
//
// Where the nodes of a group differ from their neighbours by the same few numbers, as in a grid, each of
// these differences has its slot, so that the slot's neighbours are consecutive and are read as they lie.

#include <cstdint>
#include <span>

#include "engine/aligned_buffer.h"
#include "engine/parallel_blocks.h"

namespace weft {

struct Stencil {
    static constexpr std::uint32_t lanes = 16;
    static_assert(block_size % lanes == 0, "a block is whole groups");
    static constexpr std::uint32_t no_run = ~0u;

    Stencil() = default;
    /// From compressed rows: the neighbours of node i are neighbours[offsets[i] .. offsets[i + 1]).
    Stencil(std::span<const std::uint32_t> offsets, std::span<const std::uint32_t> neighbours);

    std::uint32_t nodes = 0;
    AlignedBuffer<std::uint32_t> group_slots;  ///< slots of group g: [group_slots[g], group_slots[g + 1])
    AlignedBuffer<std::uint32_t> neighbours;   ///< [slot * lanes + lane]
    AlignedBuffer<std::uint32_t>
        runs;  ///< of each slot: its first neighbour if all are consecutive, or no_run
    AlignedBuffer<std::uint32_t> entries;  ///< of each half-edge of the rows: its slot * lanes + lane

    [[nodiscard]] std::uint32_t groups() const noexcept { return (nodes + lanes - 1) / lanes; }
    [[nodiscard]] std::uint32_t slots() const noexcept { return nodes == 0 ? 0 : group_slots[groups()]; }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return group_slots.bytes() + neighbours.bytes() + runs.bytes() + entries.bytes();
    }
};

/// Where lane `lane` of a slot's array number k lies, for values stored slot by slot as `arrays` arrays
/// of 16.
constexpr std::size_t lane_index(std::uint32_t entry, std::uint32_t k, std::uint32_t arrays) {
    const std::uint32_t slot = entry / Stencil::lanes, lane = entry % Stencil::lanes;
    return (std::size_t{slot} * arrays + k) * Stencil::lanes + lane;
}

}  // namespace weft
