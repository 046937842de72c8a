#pragma once
// By how much less than it is set to a cloth can be stepped, rung by rung. All of it are plain numbers of one
// solver: going up and down takes no memory and prepares nothing.

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

inline constexpr std::uint32_t rung_count = 5;
/// The first: as it is set.
extern const std::array<Rung, rung_count> ladder;
/// The last one without long steps.
inline constexpr std::uint32_t last_of_rate_1 = 2;
inline constexpr std::uint32_t greatest_rate = 4;

/// Of the last, where there is none of that number.
[[nodiscard]] std::uint32_t rate_of(std::uint32_t rung) noexcept;
/// A cloth's method as a rung takes it.
[[nodiscard]] Method reduced(const Method& method, std::uint32_t rung);

/// On which rung a step begins to take a cloth.
struct RungOfCloth {
    ClothId cloth;
    std::uint32_t rung = 0;
};

}  // namespace weft
