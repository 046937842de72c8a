#pragma once
// How cloth is kept from passing through itself, as the study tells it.

#include <array>

#include "weft/settings.h"

namespace weft::study {

enum class Rung {
    off,
    avoidance,  ///< particles are kept apart
    contact,    ///< features meet in the equation, and none crosses
};
inline constexpr std::array rungs{Rung::off, Rung::avoidance, Rung::contact};
[[nodiscard]] const char* name_of(Rung rung);

/// The one place that knows which settings a rung is; friction between layers stays as it is.
void set_rung(ClothSettings& settings, Rung rung);

}  // namespace weft::study
