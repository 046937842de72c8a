#include "cloth/implicit/stencil.h"

#include <algorithm>

namespace weft {

Stencil::Stencil(std::span<const std::uint32_t> offsets, std::span<const std::uint32_t> row_neighbours)
    : nodes(static_cast<std::uint32_t>(offsets.size()) - 1),
      group_slots(groups() + 1),
      entries(row_neighbours.size()) {
    const auto degree = [&](std::uint32_t node) {
        return node < nodes ? offsets[node + 1] - offsets[node] : 0;
    };
    for (std::uint32_t g = 0; g < groups(); ++g) {
        std::uint32_t most = 0;
        for (std::uint32_t lane = 0; lane < lanes; ++lane) most = std::max(most, degree(g * lanes + lane));
        group_slots[g + 1] = group_slots[g] + most;
    }
    neighbours = AlignedBuffer<std::uint32_t>(std::size_t{slots()} * lanes);
    for (std::uint32_t g = 0; g < groups(); ++g) {
        for (std::uint32_t lane = 0; lane < lanes; ++lane) {
            const std::uint32_t node = g * lanes + lane;
            for (std::uint32_t s = group_slots[g]; s < group_slots[g + 1]; ++s) {
                const std::uint32_t entry = s * lanes + lane, rank = s - group_slots[g];
                const bool used = rank < degree(node);
                neighbours[entry] = used ? row_neighbours[offsets[node] + rank] : std::min(node, nodes - 1);
                if (used) entries[offsets[node] + rank] = entry;
            }
        }
    }
}

}  // namespace weft
