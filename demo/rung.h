#pragma once
// Levels of self-collision, as users choose them and as the study reports them.

#include <array>

#include "weft/settings.h"

namespace weft::demo {

/// A level of self-collision; each guarantees more than the one before, and costs more.
enum class Rung {
    off,
    avoidance,     ///< particles are kept apart
    impact_zones,  ///< collisions of a step are resolved together, and momentum kept
    contact,       ///< contacts of features are part of the equation, and none crosses
};
inline constexpr std::array rungs{Rung::off, Rung::avoidance, Rung::impact_zones, Rung::contact};
[[nodiscard]] const char* name_of(Rung rung);

[[nodiscard]] Rung rung_of(const SelfCollision& settings);
/// Sets all settings that depend on the rung; distance and friction stay as they are.
void set_rung(SelfCollision& settings, Rung rung);

}  // namespace weft::demo
