#pragma once
// Colliders attached to a moving frame: their shapes in that frame and in the World.

#include "engine/vector.h"
#include "weft/collider.h"

namespace weft {

/// A rigid pose: point p of the local frame is at position + rotation p in the World.
struct BodyPose {
    Vector3 position = Vector3::Zero();                            ///< [m]
    Eigen::Quaternionf rotation = Eigen::Quaternionf::Identity();  ///< of unit length

    [[nodiscard]] Vector3 operator*(const Vector3& own) const { return position + rotation * own; }
    [[nodiscard]] BodyPose inverse() const;
};

/// The World's collider for one that is given in the pose's local frame.
[[nodiscard]] Collider carried(const Collider& own, const BodyPose& pose);

class HeldShape;

/// A ball that contains the collider, which is no plane. `held`: the shape of a PlacedShape.
[[nodiscard]] Sphere ball_around(const Collider& collider, const HeldShape* held);

}  // namespace weft
