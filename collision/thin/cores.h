#pragma once
// What of a collider can stick through a triangle without meeting a corner of it: the axis of what is thin,
// the edges and corners of what is sharp.

#include <array>
#include <cstdint>
#include <optional>

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
    bool is_edge = false;       ///< of a convex body, or a corner: the body itself is on one side of it

    [[nodiscard]] bool is_point() const { return axis.isZero(0); }
    [[nodiscard]] Vector3 at(float s) const { return a + s * axis; }
    [[nodiscard]] float radius_at(float s) const { return radius + s * wider; }
};

/// A collider, with the thickness, beside a triangle. What it meets beside particles is put back after the
/// step and does not rest on it, so that particles alone meet what they can hold.
enum class Thinness : std::uint8_t {
    thick,         ///< particles meet it
    thin_if_fast,  ///< slips between particles that its speed draws apart: thinner than two sides
    thin,          ///< slips between them, but they let it out again: thinner than 1.1 sides while the host
                   ///< moves it, else rods than .55 and balls than .8
    thinnest       ///< does not come out between them: thinner than two fifths; edges that move
};

/// How a collider slips through cloth, by how long sides of triangles are where it is. A step that draws
/// cells to a multiple of their size lets through what they would hold at rest.
struct Slipping {
    float thin = 0;           ///< radius with the thickness, of a body half its width [m]
    bool is_ball = false;     ///< else a rod
    bool moves = false;       ///< and no body carries it
    bool edges_part = false;  ///< they move: cloth that lies on them would not come to rest

    /// What is round of it, beside sides of that length [m].
    [[nodiscard]] Thinness as_rod(float side) const;
    /// All of it.
    [[nodiscard]] Thinness beside(float side) const { return edges_part ? Thinness::thinnest : as_rod(side); }
};
/// Nothing: it is thick beside all; also what has jumped.
[[nodiscard]] std::optional<Slipping> slipping(const ColliderMotion& motion, float h, float thickness);

/// The cores of one collider over a substep.
class Cores {
  public:
    static constexpr std::uint32_t most = 128, most_corners = HeldShape::most_edged_corners;

    /// None of planes, grounds, distance fields, and meshes without a rod that are not edged.
    Cores(const ColliderMotion& motion, float h, bool with_edges);

    [[nodiscard]] std::span<const Core> list() const { return std::span(cores_).first(count_); }
    [[nodiscard]] bool empty() const { return count_ == 0; }
    /// The first core is the axis of a capsule, along x from the origin of their space.
    [[nodiscard]] bool are_round() const { return are_round_; }
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
    /// Whether something can lie in this direction from a point of a core: of an edge, where the body is not
    /// in the way.
    [[nodiscard]] bool is_outward(const Core& core, const Vector3& own, const Vector3& direction) const;

  private:
    void add(const Vector3& a, const Vector3& b, float radius_a, float radius_b);
    void add_edge(const Vector3& a, const Vector3& b);
    void add_rod(const InnerRod& rod);
    void take_space(const struct MovingSpace& space);
    void add_round(const struct MovingCapsule& capsule, float wider, float tilt);
    void add_box(const struct MovingBox& box, bool with_edges);
    void add_held(const struct MovingHeld& held, bool with_edges);

    std::array<Core, most> cores_;
    std::uint32_t count_ = 0;
    bool are_round_ = false;
    std::array<Vector3, most_corners> corners_;  // of a convex body
    std::uint32_t corner_count_ = 0;
    Eigen::AlignedBox3f box_;
    Matrix3 to_own_, from_start_;
    Vector3 origin_, start_origin_;
    Vector3 velocity_;  // of the origin
    Matrix3 gradient_;  // what own coordinates add to it
};

}  // namespace weft
