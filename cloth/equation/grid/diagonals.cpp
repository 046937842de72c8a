#include "cloth/equation/grid/diagonals.h"

#include <algorithm>
#include <vector>

namespace weft {

Diagonals::Diagonals(std::span<const std::uint32_t> offsets, std::span<const std::uint32_t> neighbours)
    : nodes(static_cast<std::uint32_t>(offsets.size()) - 1) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < nodes && found.size() <= most; ++i) {
        std::size_t at = 0;
        for (std::uint32_t e = offsets[i]; e < offsets[i + 1]; ++e) {
            if (neighbours[e] < i) continue;
            const std::uint32_t difference = neighbours[e] - i;
            if (at > 0 && found[at - 1] >= difference) at = 0;  // rows ascend, mostly
            while (at < found.size() && found[at] < difference) ++at;
            if (at == found.size() || found[at] != difference)
                found.insert(found.begin() + static_cast<std::ptrdiff_t>(at), difference);
            ++at;
        }
    }
    const std::size_t pairs = neighbours.size() / 2;
    if (found.empty() || found.size() > most || 2 * pairs < found.size() * nodes) return;
    constexpr std::uint32_t large = 4096, fewest_reaches = 16;
    if (nodes > large && nodes / fewest_reaches < found.back()) return;
    count = static_cast<std::uint32_t>(found.size());
    std::ranges::copy(found, differences.begin());
}

std::uint32_t Diagonals::entry_between(std::uint32_t first, std::uint32_t second) const noexcept {
    const auto at = std::ranges::find(differences, second - first);
    // The difference is among them, except in a malicious file.
    return entry(first, std::min(static_cast<std::uint32_t>(at - differences.begin()), count - 1));
}

}  // namespace weft
