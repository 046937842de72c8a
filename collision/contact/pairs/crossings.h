#pragma once
// Where meshes cross: an edge through a triangle.

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/memory/scratch.h"

namespace weft {

struct Crossing {
    std::array<std::uint32_t, 2> edge;      ///< particles, numbered through all bodies
    std::array<std::uint32_t, 3> triangle;  ///< likewise
};

/// In an order that no thread decides.
struct CrossingList {
    ScratchArray<Crossing> crossings;
    std::uint32_t size = 0;
    /// There were more than there is room for: what is listed is not all.
    bool overflowed = false;

    void lay_out(Scratch& scratch, std::size_t capacity) { scratch.take(crossings, capacity); }
    [[nodiscard]] std::size_t capacity() const noexcept { return crossings.size(); }
};

}  // namespace weft
