#pragma once
// Crossings of meshes: an edge that passes through a triangle.

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/memory/scratch.h"

namespace weft {

struct Crossing {
    std::array<std::uint32_t, 2> edge;      ///< particles, numbered through all bodies
    std::array<std::uint32_t, 3> triangle;  ///< particles, numbered through all bodies
};

/// Crossings, in an order that does not depend on threads.
struct CrossingList {
    ScratchArray<Crossing> crossings;
    std::uint32_t size = 0;
    /// Whether there were more crossings than room: the list is incomplete.
    bool overflowed = false;

    void lay_out(Scratch& scratch, std::size_t capacity) { scratch.take(crossings, capacity); }
    [[nodiscard]] std::size_t capacity() const noexcept { return crossings.size(); }
};

}  // namespace weft
