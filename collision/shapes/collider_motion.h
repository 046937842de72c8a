#pragma once
// A collider's motion over one substep, and a cloth's properties in contact with it.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <string>

#include "collision/geometry/surfaces.h"
#include "engine/bounds.h"
#include "engine/vector.h"
#include "weft/collider.h"
#include "weft/error.h"

namespace weft {

class HeldShape;

/// One collider over one substep, with its state at the start and at the end.
struct ColliderMotion {
    Collider start, end;  // the same alternative in both
    /// Speed limit of its axis, of a growing surface and of a plane: particles that they meet are moved no
    /// faster, however far the collider jumps [m/s].
    float fastest = std::numeric_limits<float>::max();
    const HeldShape* held = nullptr;  ///< shape of a PlacedShape; else null
    float rate = 0;                   ///< host steps a second, if `held` deforms in this step; else 0 [1/s]
    std::int32_t body = -1;           ///< index of the body that it is attached to; -1: none
    /// The body's motion at the end [m], [m/s], [rad/s]. Spin cannot be derived from a ball's two ends.
    Vector3 centre = Vector3::Zero(), velocity = Vector3::Zero(), spin = Vector3::Zero();
    /// Swept bounding box, with the collider's own thickness; this alone rejects distant cloth.
    Bounds filled = everywhere;
};

/// Error: a value outside its range in collider.h.
[[nodiscard]] Result<void> validate(const Collider& collider);

/// Error: a length outside Rotation's range. `name` says whose rotation it is.
[[nodiscard]] Result<void> validate_rotation(const std::string& name, const Rotation& rotation);
/// The rotation by a unit quaternion; and the collider with its shape's rotation so.
[[nodiscard]] Rotation normalized(const Rotation& rotation);
[[nodiscard]] Collider normalized(Collider collider);

/// The collider a fraction t of the way from `from` to `to`: points, radius, offset and numbers are blended,
/// normals blended and normalised; layers are `to`'s. Precondition: the same alternative in both.
[[nodiscard]] Collider blend(const Collider& from, const Collider& to, float t);

/// A cloth's properties in contact with colliders. collider.h says how they combine with a collider's.
struct ClothSide {
    /// Contact distance [m] and friction coefficient of each particle.
    std::span<const float> thickness, friction;
    float most_thickness = 0;  ///< upper bound of `thickness` [m]
    float restitution = 0;
    std::uint32_t mask = ~0u;  ///< collider layers that it meets
    float least_bounce = 0;    ///< slower impacts do not bounce [m/s]
    /// Layers, of those in `mask`, that each particle meets, as whole numbers; empty: all of them.
    std::span<const float> masks = {};
    /// The cloth's normal at each particle, out of its front; empty: both sides have the same friction.
    std::span<const Vec4> normals = {};
    float back_friction = 1;  ///< friction of the back over `friction`, with `normals`

    [[nodiscard]] bool meets(const Collider& collider) const { return (collider.layers & mask) != 0; }
    [[nodiscard]] bool meets(const Collider& collider, std::uint32_t particle) const {
        const std::uint32_t own = masks.empty() ? mask : mask & static_cast<std::uint32_t>(masks[particle]);
        return (collider.layers & own) != 0;
    }
    /// Friction coefficient of the side with which the particle touches a surface of this outward normal.
    [[nodiscard]] float friction_on(const Vector3& normal, std::uint32_t particle) const {
        const bool by_back = !normals.empty() && xyz(normals[particle]).dot(normal) > 0;
        return by_back ? back_friction * friction[particle] : friction[particle];
    }
    /// The properties of `size` particles from `begin` on.
    [[nodiscard]] ClothSide part(std::uint32_t begin, std::uint32_t size) const {
        ClothSide part = *this;
        part.thickness = thickness.subspan(begin, size);
        part.friction = friction.subspan(begin, size);
        if (!masks.empty()) part.masks = masks.subspan(begin, size);
        if (!normals.empty()) part.normals = normals.subspan(begin, size);
        return part;
    }
};

/// The distance at which the collider can first touch a particle of the cloth [m].
inline float thickness_of(const ColliderMotion& motion, const ClothSide& cloth) {
    return thickness_between(cloth.most_thickness, motion.end.thickness);
}
inline float restitution_of(const ColliderMotion& motion, const ClothSide& cloth) {
    return restitution_between(cloth.restitution, motion.end.restitution);
}

}  // namespace weft
