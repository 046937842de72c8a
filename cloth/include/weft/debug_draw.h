#pragma once
// Debug drawing: the inner state of a World as lines and text, which the host draws.

#include <cstdint>

#include "weft/types.h"

namespace weft {

/// Parts to draw, combined by |.
enum class DebugParts : std::uint32_t {
    none = 0,
    strain = 1u << 0,      ///< edges: grey at rest, red where they are 5 % longer, blue where 5 % shorter
    velocities = 1u << 1,  ///< lines to where particles would be 1/60 s later
    pins = 1u << 2,        ///< pins, with lines to their targets
    contacts = 1u << 3,    ///< normals of World::contacts(), longer for larger impulses; needs its setting
    colliders = 1u << 4,   ///< surfaces of colliders
    tangles = 1u << 5,     ///< particles of crossed cloth that contact is separating
    cloths = 1u << 6,      ///< bounding boxes and text: green awake, blue asleep, grey switched off
    normals = 1u << 7,     ///< normals of particles, half an edge long
    /// Leashes and backstops. A line from a particle's place on the skin to the particle turns from green to
    /// red as the leash is used up. A violet cross marks where the backstop begins.
    leashes = 1u << 8,
    levels = 1u << 9,  ///< nodes of the multilevel method's coarse levels, larger and redder the coarser
    costs = 1u << 10,  ///< text: each cloth's time in the last step, and the whole step's
    all = ~0u,
};
constexpr DebugParts operator|(DebugParts a, DebugParts b) {
    return static_cast<DebugParts>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
constexpr bool has(DebugParts parts, DebugParts part) {
    return (static_cast<std::uint32_t>(parts) & static_cast<std::uint32_t>(part)) != 0;
}

/// Drawing callbacks of the host, called during World::debug_draw() only. Null ones are skipped. Colours are
/// red, green and blue, each from 0 to 1.
struct DebugCanvas {
    void* user = nullptr;  ///< passed to both
    void (*line)(void* user, const Vec3& from, const Vec3& to, const Vec3& colour) = nullptr;
    void (*text)(void* user, const Vec3& at, const char* words, const Vec3& colour) = nullptr;
};

}  // namespace weft
