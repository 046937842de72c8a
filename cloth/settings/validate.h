#pragma once
// Checks of what a host passes in. Nothing reaches the simulation that has not been through here.

#include "weft/body.h"
#include "weft/error.h"
#include "weft/seam.h"
#include "weft/settings.h"
#include "weft/transform.h"

namespace weft {

/// Error: the first setting that is out of its documented range.
[[nodiscard]] Result<void> validate(const WorldSettings& settings);
[[nodiscard]] Result<void> validate(const ClothSettings& settings);
[[nodiscard]] Result<void> validate(const BodySettings& settings);
[[nodiscard]] Result<void> validate(const BodyState& state);
[[nodiscard]] Result<void> validate(const SeamSettings& settings);
[[nodiscard]] Result<void> validate_importance(float importance);
/// Error: the settings exclude maps of mass or stiffness.
[[nodiscard]] Result<void> validate_for_maps(const ClothSettings& settings);
/// Error: the cloth's equation has no place for stitches.
[[nodiscard]] Result<void> validate_for_seams(const ClothSettings& settings);
/// Whether the point is finite, and within runaway_distance of the origin.
[[nodiscard]] bool is_within_reach(const Vec3& point) noexcept;
/// Error: the point is not within reach. `name` is what the message calls it.
[[nodiscard]] Result<void> validate_point(const char* name, const Vec3& point);
/// Error: the rotation is none, or the translation is not finite.
[[nodiscard]] Result<void> validate_transform(const char* name, const Transform& pose);

}  // namespace weft
