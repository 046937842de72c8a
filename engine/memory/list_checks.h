#pragma once
// What has to hold of lists that were read. They are sound, mostly: loops go through all, without a branch,
// rather than to what is first not so; and by differences, whose first bits any vector can gather. Where they
// are called one after the other a compiler takes the later ones to be rare, and would not make vectors of
// them.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "engine/memory/shared_buffer.h"

namespace weft {

/// All numbers of a list, whose items are made of them.
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

/// Ascending offsets of `rows` rows of a list of `items`.
[[nodiscard, gnu::noinline]] inline bool are_offsets(std::span<const std::uint32_t> offsets, std::size_t rows,
                                                     std::size_t items) {
    if (offsets.size() != rows + 1 || offsets[0] != 0 || offsets[rows] != items || items >= first_bit)
        return false;
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < rows; ++k) bits |= (offsets[k + 1] - offsets[k]) | offsets[k];
    return bits < first_bit;
}

/// Of -most to most; not-a-number is not.
[[nodiscard, gnu::noinline]] inline bool are_within(std::span<const float> numbers,
                                                    float most = std::numeric_limits<float>::max()) {
    const auto last = std::bit_cast<std::uint32_t>(most);
    std::uint32_t bits = 0;
    for (const float x : numbers) bits |= last - (std::bit_cast<std::uint32_t>(x) & ~first_bit);
    return bits < first_bit;
}

/// Finite, and no less than 0; -0 is not, either.
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
