#pragma once
// Settings and Worlds as text: for the log, and to tell whether two are the same.

#include <cstdint>
#include <span>
#include <string>

#include "weft/weft.h"

namespace weft::fuzz {

/// Nine digits, with which floats read back the same.
[[nodiscard]] std::string text_of(float value);
[[nodiscard]] std::string text_of(const Vec3& value);
[[nodiscard]] std::string text_of(const ClothSettings& settings);
[[nodiscard]] std::string text_of(const WorldSettings& settings);
[[nodiscard]] std::string text_of(const Collider& collider);
[[nodiscard]] std::string text_of(const ClothInfo& info);

// Snapshots have all of a World that a host can see: they tell if a call has changed anything.

/// Hash of the bytes of `values`, continued from `hash`.
[[nodiscard]] std::uint64_t fingerprint(std::span<const Vec4> values, std::uint64_t hash);

/// Settings, state hash, count of steps, and the settings, info and buffers of each cloth and collider that
/// is still there.
[[nodiscard]] std::string snapshot(const World& world, std::span<const ClothId> cloths,
                                   std::span<const ColliderId> colliders);

}  // namespace weft::fuzz
