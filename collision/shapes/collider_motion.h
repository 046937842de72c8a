#pragma once
// A collider over one substep, and what a cloth brings to its contacts with it.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>

#include "engine/bounds.h"
#include "engine/vector.h"
#include "weft/collider.h"
#include "weft/error.h"

namespace weft {

class HeldShape;

/// One collider over one substep: where it was at its start and is at its end.
struct ColliderMotion {
    Collider start, end;  // the same alternative in both
    /// No point of its axis, and no surface that grows or is a plane, moves what it meets faster than this,
    /// however far the collider jumps [m/s].
    float fastest = std::numeric_limits<float>::max();
    const HeldShape* held = nullptr;  ///< of a PlacedShape
    float rate = 0;          ///< steps of the host a second, where what is held deforms in this one [1/s]
    std::int32_t body = -1;  ///< the number of the body that carries it; -1: none
    /// Of the body at the end [m], [m/s], [rad/s]: a ball's ends have no spin.
    Vector3 centre = Vector3::Zero(), velocity = Vector3::Zero(), spin = Vector3::Zero();
    /// Around all that it fills on its way, with its own thickness: what is far off is told by this alone.
    Bounds filled = everywhere;
};

/// Error: a value outside its range in collider.h.
[[nodiscard]] Result<void> validate(const Collider& collider);

/// The collider a fraction t of the way from `from` to `to`: points, radius, offset and numbers are blended,
/// normals blended and normalised; layers are `to`'s. Precondition: the same alternative in both.
[[nodiscard]] Collider blend(const Collider& from, const Collider& to, float t);

/// What a cloth brings to its contacts with colliders. How the two go together, collider.h says.
struct ClothSide {
    /// Each particle keeps such a distance [m], and has such a friction.
    std::span<const float> thickness, friction;
    float most_thickness = 0;  ///< no particle's is more [m]
    float restitution = 0;
    std::uint32_t mask = ~0u;  ///< of the layers that it meets
    float least_bounce = 0;    ///< what comes slower does not bounce [m/s]

    [[nodiscard]] bool meets(const Collider& collider) const { return (collider.layers & mask) != 0; }
    /// The same of some of its particles.
    [[nodiscard]] ClothSide part(std::uint32_t begin, std::uint32_t size) const {
        ClothSide part = *this;
        part.thickness = thickness.subspan(begin, size);
        part.friction = friction.subspan(begin, size);
        return part;
    }
};

/// The distance at which the collider can first touch a particle of the cloth [m].
inline float thickness_of(const ColliderMotion& motion, const ClothSide& cloth) {
    return cloth.most_thickness + motion.end.thickness;
}
inline float restitution_of(const ColliderMotion& motion, const ClothSide& cloth) {
    return std::max(cloth.restitution, motion.end.restitution);
}

}  // namespace weft
