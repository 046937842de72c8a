#pragma once
// What a host can see of a World, as text, to tell whether a call has changed anything.

#include <cstdint>
#include <span>
#include <string>

#include "weft/weft.h"

namespace weft::fuzz {

/// Of the bytes of `values`, going on from `hash`.
[[nodiscard]] std::uint64_t fingerprint(std::span<const Vec4> values, std::uint64_t hash);

/// Settings, state hash, count of steps, and the settings, info and buffers of each cloth and collider that
/// is still there.
[[nodiscard]] std::string snapshot(const World& world, std::span<const ClothId> cloths,
                                   std::span<const ColliderId> colliders);

}  // namespace weft::fuzz
