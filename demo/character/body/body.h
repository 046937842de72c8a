#pragma once
// A body of tapered capsules that follows a skeleton, as thick as its bones' lengths let expect.

#include <vector>

#include "demo/character/body/body_joints.h"
#include "weft/collider.h"

namespace weft::demo {

/// A tapered capsule whose ends each stand still as seen from a joint.
struct Limb {
    struct End {
        std::size_t joint;
        Vector3 local;  ///< [m], in the joint's axes
        float radius;   ///< [m]
    };
    End a, b;
};

class Body {
  public:
    /// Error: find_body_joints', or bones of no length, by name.
    [[nodiscard]] static Result<Body> create(const Skeleton& skeleton);

    [[nodiscard]] const std::vector<Limb>& limbs() const { return limbs_; }
    [[nodiscard]] const BodyJoints& joints() const { return joints_; }
    /// What limb `limb` is in this pose, its radii times `growth`.
    [[nodiscard]] TaperedCapsule placed(std::size_t limb, const Pose& pose, float growth = 1) const;
    /// All of it.
    void place(const Pose& pose, float growth, std::vector<TaperedCapsule>& capsules) const;

    /// Upright on the ground: legs straight, `apart` times their length to the side, arms lowered by `arms`
    /// degrees from the horizontal.
    [[nodiscard]] JointAngles stance(const Skeleton& skeleton, float arms, float apart = 0.02f) const;

  private:
    Body(BodyJoints joints, std::vector<Limb> limbs) : joints_(joints), limbs_(std::move(limbs)) {}

    BodyJoints joints_;
    std::vector<Limb> limbs_;
};

/// Of a point from a tapered capsule's surface [m], negative inside, and the way out.
struct SurfaceDistance {
    float distance;
    Vector3 normal;
};
[[nodiscard]] SurfaceDistance distance_to(const TaperedCapsule& capsule, const Vector3& point);

}  // namespace weft::demo
