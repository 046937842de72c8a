#pragma once
// What goes on inside a World, as lines and words that a host draws with what it has.

#include <cstdint>

#include "weft/types.h"

namespace weft {

/// What is drawn; several together by |.
enum class DebugParts : std::uint32_t {
    none = 0,
    strain = 1u << 0,      ///< edges: grey at rest, red where they are 5 % longer, blue where 5 % shorter
    velocities = 1u << 1,  ///< where particles would be a frame of 1/60 s later
    pins = 1u << 2,        ///< and how far they are from their targets
    contacts = 1u << 3,    ///< normals of World::contacts(), longer where more is pushed; needs its setting
    colliders = 1u << 4,   ///< their surfaces
    tangles = 1u << 5,     ///< particles of what is let apart, by contact
    cloths = 1u << 6,      ///< boxes and words: green awake, blue asleep, grey switched off
    normals = 1u << 7,     ///< of particles, half an edge long
    /// Skins of leashes and backstops: from a particle's place there to it, green, red where its leash ends;
    /// and where its backstop begins, violet.
    leashes = 1u << 8,
    levels = 1u << 9,  ///< nodes of the multilevel method's coarse levels, larger and redder the coarser
    costs = 1u << 10,  ///< words: what each cloth cost in the last step, with the whole step
    all = ~0u,
};
constexpr DebugParts operator|(DebugParts a, DebugParts b) {
    return static_cast<DebugParts>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
constexpr bool has(DebugParts parts, DebugParts part) {
    return (static_cast<std::uint32_t>(parts) & static_cast<std::uint32_t>(part)) != 0;
}

/// The host's own drawing, called from World::debug_draw() and kept no longer. What is null is left out.
/// Colours are red, green and blue, each from 0 to 1.
struct DebugCanvas {
    void* user = nullptr;  ///< handed back
    void (*line)(void* user, const Vec3& from, const Vec3& to, const Vec3& colour) = nullptr;
    void (*text)(void* user, const Vec3& at, const char* words, const Vec3& colour) = nullptr;
};

}  // namespace weft
