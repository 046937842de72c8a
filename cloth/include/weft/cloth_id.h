#pragma once
// Identifies a cloth in a World.

#include <cstdint>

namespace weft {

/// Generation-checked; all-zero is null.
struct ClothId {
    std::uint32_t index = 0, generation = 0;
    friend bool operator==(ClothId, ClothId) = default;
};

}  // namespace weft
