#pragma once
// What of a collider can stick through a triangle without meeting a corner of it: the axis of what is thin,
// the edges and corners of what is sharp.

#include <array>
#include <cstdint>

#include "collision/colliders/collider_contacts.h"
#include "collision/shapes/held_shape.h"
#include "collision/thin/sides_kernels.h"
#include "engine/vector.h"

namespace weft {

/// A segment or a point of a collider, in a space of the collider's own in which it stands still, with balls
/// about it.
struct Core {
    Vector3 a = Vector3::Zero(), axis = Vector3::Zero();  ///< [m]; a point has no axis
    float radius = 0, wider = 0;  ///< about a, and what it is more at the other end [m]
    float tilt = 0;  ///< of the nearest ball's fraction, beyond the foot on the axis, by the distance [1/m]
    Eigen::AlignedBox3f box{};  ///< around all of it

    [[nodiscard]] bool is_point() const { return axis.isZero(0); }
    [[nodiscard]] Vector3 at(float s) const { return a + s * axis; }
    [[nodiscard]] float radius_at(float s) const { return radius + s * wider; }
};

/// A collider, with the thickness, beside a cloth's edges, of that length at rest. What it meets beside
/// particles is put back after the step and does not rest on it, so that particles alone meet what they can
/// hold.
enum class Thinness : std::uint8_t {
    thick,         ///< particles meet it; also what has jumped
    thin_if_fast,  ///< slips between particles that its speed draws apart: thinner than two edges
    thin,          ///< slips between them, but they let it out again: thinner than 1.1 edges while the host
                   ///< moves it, else rods than .55 and balls than .8
    thinnest       ///< does not come out between them: thinner than two fifths; moving boxes and hulls
};
[[nodiscard]] Thinness thinness_of(const ColliderMotion& motion, float h, float thickness, float mean_edge);

/// The cores of one collider over a substep.
class Cores {
  public:
    static constexpr std::uint32_t most = 128, most_corners = HeldShape::most_edged_corners;

    /// None of planes, grounds, distance fields, and shapes that are not edged.
    Cores(const ColliderMotion& motion, float h);

    [[nodiscard]] std::span<const Core> list() const { return std::span(cores_).first(count_); }
    [[nodiscard]] bool empty() const { return count_ == 0; }
    /// Around all of them.
    [[nodiscard]] const Eigen::AlignedBox3f& box() const { return box_; }

    /// The same, in the World, and wider by so much on all sides.
    [[nodiscard]] TurningBox turning_box(float margin) const {
        return {to_own_,
                from_start_,
                origin_,
                start_origin_,
                box_.min() - Vector3::Constant(margin),
                box_.max() + Vector3::Constant(margin)};
    }
    /// Of points of the World at the substep's start and its end.
    [[nodiscard]] Vector3 seen_at_start(const Vector3& p) const { return from_start_ * (p - start_origin_); }
    [[nodiscard]] Vector3 seen(const Vector3& p) const { return to_own_ * (p - origin_); }
    [[nodiscard]] Vector3 place(const Vector3& own) const { return origin_ + in_world(own); }
    [[nodiscard]] Vector3 in_world(const Vector3& direction) const { return to_own_.transpose() * direction; }
    /// Of a point of a core, which the World has at the end [m/s].
    [[nodiscard]] Vector3 velocity_at(const Vector3& own) const;
    /// Whether something can lie in this direction from a point of a core: of a body none of which is in the
    /// way.
    [[nodiscard]] bool is_outward(const Vector3& own, const Vector3& direction) const;

  private:
    void add(const Vector3& a, const Vector3& b, float radius_a = 0, float radius_b = 0);
    void take_space(const struct MovingSpace& space);
    void add_round(const struct MovingCapsule& capsule, float wider, float tilt);
    void add_box(const struct MovingBox& box);
    void add_hull(const struct MovingHeld& held);

    std::array<Core, most> cores_;
    std::uint32_t count_ = 0;
    std::array<Vector3, most_corners> corners_;  // of a convex body
    std::uint32_t corner_count_ = 0;
    Eigen::AlignedBox3f box_;
    Matrix3 to_own_, from_start_;
    Vector3 origin_, start_origin_;
    Vector3 velocity_;  // of the origin
    Matrix3 gradient_;  // what own coordinates add to it
};

}  // namespace weft
