#pragma once
// A body of tapered capsules that follows a skeleton, and distances to their surfaces. Radii are in
// proportion to bone lengths.

#include <vector>

#include "demo/character/body/body_joints.h"
#include "engine/vector.h"
#include "weft/collider.h"

namespace weft::demo {

/// Signed distance of a point from a surface [m], negative inside, and the outward normal.
struct SurfaceDistance {
    float distance;
    Vector3 normal;
};

/// The surface of a tapered capsule as a distance function.
/// Unless one ball contains the other, a cone joins them. It touches each ball in a circle whose plane is
/// `sine` times the radius from the centre, along the axis (I. Quilez, "Round cone", 2018).
class RoundCone {
  public:
    RoundCone(const Vector3& a, const Vector3& b, float radius_a, float radius_b);
    explicit RoundCone(const TaperedCapsule& capsule)
        : RoundCone(to_vector(capsule.a), to_vector(capsule.b), capsule.radius_a, capsule.radius_b) {}

    [[nodiscard]] SurfaceDistance distance_to(const Vector3& point) const;
    [[nodiscard]] bool contains(const Vector3& point) const { return distance_to(point).distance <= 0; }

  private:
    Vector3 a_, b_, along_;
    float radius_a_, radius_b_, length_, sine_ = 0, cosine_ = 1;
    bool is_ball_;  // one ball contains the other
};

/// The part of a person that a limb stands for.
enum class LimbKind : std::uint8_t {
    trunk,
    neck,
    head,
    shoulder,
    arm,
    forearm,
    hand,
    thigh,
    shin,
    sole,
    foot
};

/// A tapered capsule. Each end is fixed in a joint's frame.
struct Limb {
    struct End {
        std::size_t joint;
        Vector3 local;  ///< [m], in the joint's axes
        float radius;   ///< [m]
    };
    End a, b;
    LimbKind kind;
};

class Body {
  public:
    /// Error: find_body_joints()'s, or a bone outside 0.01 to 10 m, with its joints' names.
    [[nodiscard]] static Result<Body> create(const Skeleton& skeleton);

    [[nodiscard]] const std::vector<Limb>& limbs() const { return limbs_; }
    [[nodiscard]] const BodyJoints& joints() const { return joints_; }
    /// Limb `limb` in this pose, its radii multiplied by `growth`.
    [[nodiscard]] TaperedCapsule placed(std::size_t limb, const Pose& pose, float growth = 1) const;
    /// Writes placed() of all limbs.
    void place(const Pose& pose, float growth, std::vector<TaperedCapsule>& capsules) const;

    /// Joint angles of a person upright on the ground. Straight legs stand `apart` times their length to the
    /// side; arms are lowered by `arms` degrees from the horizontal.
    [[nodiscard]] JointAngles stance(const Skeleton& skeleton, float arms, float apart = 0.02f) const;

  private:
    Body(BodyJoints joints, std::vector<Limb> limbs) : joints_(joints), limbs_(std::move(limbs)) {}

    BodyJoints joints_;
    std::vector<Limb> limbs_;
};

/// Signed distance of a point from a tapered capsule's surface [m], and the outward normal.
[[nodiscard]] SurfaceDistance distance_to(const TaperedCapsule& capsule, const Vector3& point);

}  // namespace weft::demo
