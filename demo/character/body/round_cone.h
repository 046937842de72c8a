#pragma once
// The surface of a tapered capsule as a distance function.

#include "engine/vector.h"
#include "weft/collider.h"

namespace weft::demo {

/// Signed distance of a point from a surface [m], negative inside, and the outward normal.
struct SurfaceDistance {
    float distance;
    Vector3 normal;
};

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

}  // namespace weft::demo
