#pragma once
// How cloth is kept from passing through cloth, as people choose it and as the study tells it.

#include <array>

#include "weft/settings.h"

namespace weft::demo {

/// Of the ladder; each promises more than the one before, and costs more.
enum class Rung {
    off,
    avoidance,     ///< particles are kept apart
    impact_zones,  ///< collisions of a step are resolved together, and momentum kept
    contact,       ///< features meet in the equation, and none crosses
};
inline constexpr std::array rungs{Rung::off, Rung::avoidance, Rung::impact_zones, Rung::contact};
[[nodiscard]] const char* name_of(Rung rung);

[[nodiscard]] Rung rung_of(const SelfCollision& settings);
/// The one place that knows which settings a rung is; distance and friction stay as they are.
void set_rung(SelfCollision& settings, Rung rung);

}  // namespace weft::demo
