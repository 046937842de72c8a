#pragma once
// A filter of pairs that are close at rest.

#include <cstdint>
#include <span>

namespace weft {

/// For particle i, `neighbours[offsets[i] .. offsets[i + 1])`, ascending, are the particles with which it
/// makes no contact. Empty: no filter.
struct RestFilter {
    std::span<const std::uint32_t> offsets, neighbours;

    [[nodiscard]] bool leaves_alone(std::uint32_t i, std::uint32_t j) const {
        if (offsets.empty()) return false;
        // Most lists are short, and are read to the end: a branch on each entry would cost more.
        constexpr std::uint32_t short_list = 16;
        std::uint32_t first = offsets[i], count = offsets[i + 1] - first;
        for (; count > short_list; count -= count / 2)
            first += neighbours[first + count / 2 - 1] < j ? count / 2 : 0;
        bool found = false;
        for (std::uint32_t k = first; k < first + count; ++k) found |= neighbours[k] == j;
        return found;
    }
};

}  // namespace weft
