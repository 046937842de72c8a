#pragma once
// Shelters: places that keep the wind and its gusts off.

#include <algorithm>
#include <span>

#include "engine/threads/parallel_blocks.h"
#include "weft/settings.h"

namespace weft {

[[nodiscard]] inline bool has_shelters(const Wind& wind) {
    return std::ranges::any_of(
        wind.shelters, [](const AirShelter& shelter) { return shelter.kind != AirShelterKind::none; });
}

/// Multiplies the air's velocities at points [m] by what the shelters let through.
void shelter_air(Parallel& parallel, const Wind& wind, std::span<const Vec4> points,
                 std::span<Vec4> velocities);

}  // namespace weft
