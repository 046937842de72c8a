#pragma once
// What has to hold of lists that were read. They are sound, mostly: loops go through all, without a branch,
// rather than to what is first not so.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace weft {

[[nodiscard]] inline bool are_below(std::span<const std::uint32_t> numbers, std::size_t end) {
    const auto first_wrong = static_cast<std::uint32_t>(std::min<std::size_t>(end, ~0u));
    std::uint32_t wrong = 0;
    for (const std::uint32_t number : numbers) wrong |= number >= first_wrong ? 1u : 0u;
    return wrong == 0;
}

/// Not-a-number is not.
[[nodiscard]] inline bool are_within(std::span<const float> numbers, float least, float most) {
    std::uint32_t wrong = 0;
    for (const float x : numbers) wrong |= (x >= least ? 0u : 1u) | (x <= most ? 0u : 1u);
    return wrong == 0;
}

/// Ascending offsets of `rows` rows of a list of `items`.
[[nodiscard]] inline bool are_offsets(std::span<const std::uint32_t> offsets, std::size_t rows,
                                      std::size_t items) {
    if (offsets.size() != rows + 1 || offsets[0] != 0 || offsets[rows] != items) return false;
    std::uint32_t wrong = 0;
    for (std::size_t k = 0; k < rows; ++k) wrong |= offsets[k] > offsets[k + 1] ? 1u : 0u;
    return wrong == 0;
}

}  // namespace weft
