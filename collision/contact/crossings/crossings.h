#pragma once
// Where meshes cross: an edge through a triangle.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "engine/memory/aligned_buffer.h"

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

    /// Crossings are listed as if there were room for no more.
    std::size_t limit = std::numeric_limits<std::size_t>::max();

    CrossingList() = default;
    explicit CrossingList(std::size_t capacity) : crossings(capacity) {}
    [[nodiscard]] std::size_t capacity() const noexcept { return std::min(limit, crossings.size()); }
    [[nodiscard]] std::size_t bytes() const noexcept { return crossings.bytes(); }
};

}  // namespace weft
