#pragma once
// By how much less than it is set to a cloth can be stepped, rung by rung. All of it are plain numbers of one
// solver: going up and down takes no memory and prepares nothing.

#include <algorithm>
#include <array>
#include <cstdint>

#include "weft/cloth_id.h"
#include "weft/methods.h"

namespace weft {

struct Rung {
    int passes;          ///< of Multilevel, at most; others stay as they are set
    std::uint32_t rate;  ///< steps of the World that one of the cloth is long
    float cost;          ///< of a step over that of the first rung, until it is measured
    float error;         ///< of motion, over that of the last rung
};

/// The first: as it is set.
inline constexpr std::array<Rung, 5> ladder{
    {{0, 1, 1.0f, 0.0f}, {2, 1, 0.7f, 0.25f}, {1, 1, 0.5f, 0.5f}, {1, 2, 0.28f, 0.75f}, {1, 4, 0.17f, 1.0f}}};
inline constexpr auto rung_count = static_cast<std::uint32_t>(ladder.size());
/// The last one without long steps.
inline constexpr std::uint32_t last_of_rate_1 = 2;

[[nodiscard]] inline const Rung& rung_at(std::uint32_t rung) {
    return ladder[std::min(rung, rung_count - 1)];
}
[[nodiscard]] inline std::uint32_t rate_of(std::uint32_t rung) {
    return rung_at(rung).rate;
}

/// A cloth's method as a rung takes it.
[[nodiscard]] inline Method reduced(const Method& method, std::uint32_t rung) {
    const auto* const own = std::get_if<Multilevel>(&method);
    if (rung == 0 || own == nullptr) return method;
    Multilevel less = *own;
    less.passes = std::min(own->passes, rung_at(rung).passes);
    less.iterations = 1;
    less.effort = 1;
    return less;
}

/// On which rung a step begins to take a cloth.
struct RungOfCloth {
    ClothId cloth;
    std::uint32_t rung = 0;
};

}  // namespace weft
