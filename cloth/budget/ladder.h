#pragma once
// Levels of detail (rungs) on which a cloth costs less than as it is set. Rungs differ in plain numbers of
// one solver, so that a change takes no memory and prepares nothing.

#include <array>
#include <cstdint>

#include "weft/cloth_id.h"
#include "weft/methods.h"

namespace weft {

struct Rung {
    int passes;          ///< most passes of Multilevel in steps of rate 1; long steps take all that are set
    std::uint32_t rate;  ///< length of a cloth's step, in steps of the World
    float cost;          ///< cost over the first rung's, until it is measured
    float error;         ///< error of the motion over the last rung's
};

inline constexpr std::uint32_t rung_count = 3;
/// The most levels of a garment: see simulation/garment.h.
inline constexpr std::uint32_t most_garment_levels = 4;
/// All rungs; the first is the cloth as it is set.
extern const std::array<Rung, rung_count> ladder;
/// The last rung without long steps.
inline constexpr std::uint32_t last_of_rate_1 = 1;
inline constexpr std::uint32_t greatest_rate = 2;

/// The rate of a rung; a number beyond the last rung counts as the last.
[[nodiscard]] std::uint32_t rate_of(std::uint32_t rung) noexcept;
/// A cloth's method in a step of that rung and rate.
[[nodiscard]] Method reduced(const Method& method, std::uint32_t rung, std::uint32_t rate);

/// The rung on which a step begins to take a cloth; or, of a garment, another level than the cloth's, which
/// takes over after the step: level * rung_count + the rung there.
struct RungOfCloth {
    ClothId cloth;
    std::uint32_t rung = 0;
};

}  // namespace weft
