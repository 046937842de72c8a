#include "cloth/equation/sparse/stencil.h"

#include <algorithm>
#include <vector>

#include "engine/memory/list_checks.h"

namespace weft {

namespace {

/// The compressed rows that a stencil is made from.
struct Rows {
    std::span<const std::uint32_t> offsets, neighbours;

    [[nodiscard]] std::uint32_t nodes() const { return static_cast<std::uint32_t>(offsets.size()) - 1; }
    [[nodiscard]] std::uint32_t degree(std::uint32_t node) const {
        return node < nodes() ? offsets[node + 1] - offsets[node] : 0;
    }
    /// Neighbour minus node, of half-edge e of the node.
    [[nodiscard]] std::int64_t difference(std::uint32_t node, std::uint32_t e) const {
        return std::int64_t{neighbours[e]} - node;
    }
};

std::uint32_t most_neighbours(const Rows& rows, std::uint32_t group) {
    std::uint32_t most = 0;
    for (std::uint32_t lane = 0; lane < Stencil::lanes; ++lane)
        most = std::max(most, rows.degree(group * Stencil::lanes + lane));
    return most;
}

/// Writes every difference that occurs in a group, ascending. False: there are more than `most`.
bool find_differences(const Rows& rows, std::uint32_t group, std::uint32_t most,
                      std::vector<std::int64_t>& found) {
    found.clear();
    const std::uint32_t end = std::min((group + 1) * Stencil::lanes, rows.nodes());
    for (std::uint32_t node = group * Stencil::lanes; node < end; ++node) {
        std::size_t at = 0;
        for (std::uint32_t e = rows.offsets[node]; e < rows.offsets[node + 1]; ++e) {
            const std::int64_t difference = rows.difference(node, e);
            if (at > 0 && found[at - 1] >= difference) at = 0;  // rows ascend, mostly
            while (at < found.size() && found[at] < difference) ++at;
            if (at == found.size() || found[at] != difference) {
                if (found.size() == most) return false;
                found.insert(found.begin() + static_cast<std::ptrdiff_t>(at), difference);
            }
            ++at;
        }
    }
    return true;
}

/// The first row of a slot's run, or no_run if the run would leave the rows, which end with the last group.
std::uint32_t run_at(std::int64_t difference, std::uint32_t group, std::uint32_t groups) {
    const std::int64_t first = std::int64_t{group} * Stencil::lanes + difference;
    const std::int64_t last = std::int64_t{groups - 1} * Stencil::lanes;
    return first >= 0 && first <= last ? static_cast<std::uint32_t>(first) : Stencil::no_run;
}

}  // namespace

Stencil::Stencil(std::span<const std::uint32_t> offsets, std::span<const std::uint32_t> row_neighbours,
                 Order order)
    : nodes(static_cast<std::uint32_t>(offsets.size()) - 1),
      group_slots(groups() + 1),
      slot_of(row_neighbours.size()) {
    const Rows rows{offsets, row_neighbours};
    for (std::uint32_t g = 0; g < groups(); ++g)
        group_slots[g + 1] = group_slots[g] + most_neighbours(rows, g);
    neighbours = SharedBuffer<std::uint32_t>(std::size_t{slots()} * lanes);
    runs = SharedBuffer<std::uint32_t>(slots());
    std::vector<std::int64_t> differences;
    for (std::uint32_t g = 0; g < groups(); ++g) {
        const std::uint32_t first_slot = group_slots[g], slot_count = group_slots[g + 1] - first_slot;
        const bool by_difference =
            order == Order::by_difference && find_differences(rows, g, slot_count, differences);
        for (std::uint32_t s = 0; s < slot_count; ++s)
            runs[first_slot + s] = by_difference ? run_at(differences[s], g, groups()) : no_run;
        for (std::uint32_t lane = 0; lane < lanes; ++lane) {
            const std::uint32_t node = std::min(g * lanes + lane, nodes - 1);
            std::uint32_t next = offsets[node];
            const std::uint32_t end = next + rows.degree(g * lanes + lane);
            for (std::uint32_t s = 0; s < slot_count; ++s) {
                const std::uint32_t entry = (first_slot + s) * lanes + lane;
                const bool used =
                    next < end && (!by_difference || rows.difference(node, next) == differences[s]);
                neighbours[entry] = used ? row_neighbours[next] : node;
                if (used) slot_of[next++] = static_cast<std::uint16_t>(s);
            }
        }
    }
}

bool Stencil::is_sound(std::uint32_t node_count, std::size_t half_edges) const {
    if (nodes != node_count || !are_offsets(group_slots.span(), groups(), runs.size()) ||
        neighbours.size() != runs.size() * lanes || slot_of.size() != half_edges)
        return false;
    const std::uint32_t last = (groups() - 1) * lanes;
    std::uint32_t wrong = 0;
    for (const std::uint32_t run : runs) wrong |= (run > last ? 1u : 0u) & (run != no_run ? 1u : 0u);
    return wrong == 0 && are_below(neighbours.span(), nodes);
}

std::uint32_t Stencil::group_of(std::uint32_t slot) const noexcept {
    const auto next = std::ranges::upper_bound(group_slots.span(), slot);
    return static_cast<std::uint32_t>(next - group_slots.span().begin()) - 1;
}

std::uint32_t Stencil::node_of(std::uint32_t slot, std::uint32_t lane) const noexcept {
    return std::min(group_of(slot) * lanes + lane, nodes - 1);
}

}  // namespace weft
