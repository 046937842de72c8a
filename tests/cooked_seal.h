#pragma once
// The checksum of a cooked cloth's file, made right again after bytes were changed.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "engine/state_hash.h"

namespace weft::test {

/// Bytes of the head, at whose end the checksum is.
inline constexpr std::size_t cooked_head = 64;

inline void seal_cooked(std::vector<std::byte>& bytes) {
    constexpr std::size_t sum_at = cooked_head - 8, piece = 65536;
    std::fill_n(bytes.begin() + sum_at, 8, std::byte{});
    std::array<std::byte, cooked_head> head;
    std::memcpy(head.data(), bytes.data(), cooked_head);
    StateHash hash;
    hash.add(std::span(&head, 1));
    for (std::size_t at = cooked_head; at < bytes.size(); at += piece)
        hash.add(std::span<const std::byte>(bytes).subspan(at, std::min(piece, bytes.size() - at)));
    const std::uint64_t value = hash.value();
    std::memcpy(bytes.data() + sum_at, &value, 8);
}

}  // namespace weft::test
