#pragma once
// Checks of what a host passes in. Nothing reaches the simulation that has not been through here.

#include "weft/error.h"
#include "weft/settings.h"

namespace weft {

/// Error: the first setting that is out of its documented range.
[[nodiscard]] Result<void> validate(const WorldSettings& settings);
[[nodiscard]] Result<void> validate(const ClothSettings& settings);
[[nodiscard]] Result<void> validate_importance(float priority, float view_distance);
/// Error: they leave no room for maps of mass or stiffness.
[[nodiscard]] Result<void> validate_for_maps(const ClothSettings& settings);
/// Error: a point that is not finite or beyond runaway_distance. `name` is what the message calls it.
[[nodiscard]] Result<void> validate_point(const char* name, const Vec3& point);

}  // namespace weft
