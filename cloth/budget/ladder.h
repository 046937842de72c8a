#pragma once
// How a cloth can be stepped for less than as it is set, rung by rung. Rungs differ in plain numbers of one
// solver, so that a change of them takes no memory and prepares nothing.

#include <array>
#include <cstdint>

#include "weft/cloth_id.h"
#include "weft/methods.h"

namespace weft {

struct Rung {
    int passes;          ///< of Multilevel in steps of rate 1, at most; long steps take all that are set
    std::uint32_t rate;  ///< steps of the World that one of the cloth is long
    float cost;          ///< of a step over that of the first rung, until it is measured
    float error;         ///< of motion, over that of the last rung
};

inline constexpr std::uint32_t rung_count = 3;
/// The first rung is the cloth as it is set.
extern const std::array<Rung, rung_count> ladder;
/// The last rung without long steps.
inline constexpr std::uint32_t last_of_rate_1 = 1;
inline constexpr std::uint32_t greatest_rate = 2;

/// The rate of a rung; of the last, where there is none of that number.
[[nodiscard]] std::uint32_t rate_of(std::uint32_t rung) noexcept;
/// A cloth's method in a step of that rung and rate.
[[nodiscard]] Method reduced(const Method& method, std::uint32_t rung, std::uint32_t rate);

/// On which rung a step begins to take a cloth.
struct RungOfCloth {
    ClothId cloth;
    std::uint32_t rung = 0;
};

}  // namespace weft
