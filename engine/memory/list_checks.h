#pragma once
// Checks of lists that were read. Most lists are sound, so loops test all numbers without a branch instead of
// stopping at the first fault. They gather the top bits of differences, which any vector unit can do. The
// checks are not inlined: a compiler takes the later ones of a chain to be rare and would not vectorise them.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "engine/memory/shared_buffer.h"

namespace weft {

/// The numbers that a list's items are made of.
template <class Number, class Item>
[[nodiscard]] std::span<const Number> numbers_of(const SharedBuffer<Item>& list) {
    static_assert(sizeof(Item) % sizeof(Number) == 0);
    return {reinterpret_cast<const Number*>(list.data()), list.size() * (sizeof(Item) / sizeof(Number))};
}

inline constexpr std::uint32_t first_bit = 1u << 31;

[[nodiscard, gnu::noinline]] inline bool are_below(std::span<const std::uint32_t> numbers, std::size_t end) {
    if (numbers.empty()) return true;
    if (end == 0) return false;
    const auto last = static_cast<std::uint32_t>(std::min<std::size_t>(end - 1, ~0u));
    if (last >= first_bit) return *std::ranges::max_element(numbers) <= last;
    std::uint32_t bits = 0;
    for (const std::uint32_t number : numbers) bits |= (last - number) | number;
    return bits < first_bit;
}

/// Whether these are ascending offsets of `rows` rows in a list of `items`.
[[nodiscard, gnu::noinline]] inline bool are_offsets(std::span<const std::uint32_t> offsets, std::size_t rows,
                                                     std::size_t items) {
    if (offsets.size() != rows + 1 || offsets[0] != 0 || offsets[rows] != items || items >= first_bit)
        return false;
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < rows; ++k) bits |= (offsets[k + 1] - offsets[k]) | offsets[k];
    return bits < first_bit;
}

/// Whether all numbers are from -most to most; one that is not a number is not.
[[nodiscard, gnu::noinline]] inline bool are_within(std::span<const float> numbers,
                                                    float most = std::numeric_limits<float>::max()) {
    const auto last = std::bit_cast<std::uint32_t>(most);
    std::uint32_t bits = 0;
    for (const float x : numbers) bits |= last - (std::bit_cast<std::uint32_t>(x) & ~first_bit);
    return bits < first_bit;
}

/// Whether all numbers are finite and at least 0; -0 does not count as 0.
[[nodiscard, gnu::noinline]] inline bool are_from_zero(std::span<const float> numbers) {
    constexpr auto last = std::bit_cast<std::uint32_t>(std::numeric_limits<float>::max());
    std::uint32_t bits = 0;
    for (const float x : numbers) {
        const auto number = std::bit_cast<std::uint32_t>(x);
        bits |= (last - number) | number;
    }
    return bits < first_bit;
}

}  // namespace weft
