#pragma once
// Where meshes cross: an edge through a triangle.

#include <array>
#include <cstdint>

#include "engine/aligned_buffer.h"

namespace weft {

struct Crossing {
    std::array<std::uint32_t, 2> edge;      ///< particles, numbered through all bodies
    std::array<std::uint32_t, 3> triangle;  ///< likewise
};

/// In an order that no thread decides.
struct CrossingList {
    AlignedBuffer<Crossing> crossings;
    std::uint32_t size = 0;
    /// There were more than there is room for: what is listed is not all.
    bool overflowed = false;

    CrossingList() = default;
    explicit CrossingList(std::size_t capacity) : crossings(capacity) {}
    [[nodiscard]] std::size_t capacity() const noexcept { return crossings.size(); }
    [[nodiscard]] std::size_t bytes() const noexcept { return crossings.bytes(); }
};

}  // namespace weft
