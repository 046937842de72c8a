#pragma once
// Colliders that something else carries: their shapes in its frame and in the World.

#include "engine/vector.h"
#include "weft/collider.h"

namespace weft {

/// Where something is: what is at p in its own frame is at position + rotation p in the World.
struct BodyPose {
    Vector3 position = Vector3::Zero();                            ///< [m]
    Eigen::Quaternionf rotation = Eigen::Quaternionf::Identity();  ///< of unit length

    [[nodiscard]] Vector3 operator*(const Vector3& own) const { return position + rotation * own; }
    [[nodiscard]] BodyPose inverse() const;
};

/// A collider, given in the frame of what is there, in the World.
[[nodiscard]] Collider carried(const Collider& own, const BodyPose& pose);

class HeldShape;

/// One that holds the collider, which is no plane. `held`: of a PlacedShape.
[[nodiscard]] Sphere ball_around(const Collider& collider, const HeldShape* held);

}  // namespace weft
