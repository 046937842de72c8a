#pragma once
// Cores: parts of a collider that can pass through a triangle without touching its corners. They are the axes
// of thin colliders, and the edges and corners of sharp ones.

#include <array>
#include <cstdint>
#include <optional>

#include "collision/colliders/collider_contacts.h"
#include "collision/shapes/held_shape.h"
#include "collision/thin/sides_kernels.h"
#include "engine/vector.h"

namespace weft {

/// A segment or a point of a collider, with balls about it, in a local frame of the collider in which it
/// stands still.
struct Core {
    Vector3 a = Vector3::Zero(), axis = Vector3::Zero();  ///< [m]; a point has no axis
    float radius = 0, wider = 0;  ///< radius at a; radius at the other end less it [m]
    float tilt = 0;  ///< fraction of the nearest ball less the foot's, per distance from the axis [1/m]
    Eigen::AlignedBox3f box{};  ///< bounding box with the balls
    bool is_edge = false;       ///< an edge or corner of a convex body, which is on one side of it

    [[nodiscard]] bool is_point() const { return axis.isZero(0); }
    [[nodiscard]] Vector3 at(float s) const { return a + s * axis; }
    [[nodiscard]] float radius_at(float s) const { return radius + s * wider; }
};

/// How thin a collider, with the thickness, is beside a triangle. Contact between particles is corrected
/// after the step and nothing comes to rest on it, so colliders that particles can hold are left to
/// particles.
enum class Thinness : std::uint8_t {
    thick,         ///< particles meet it
    thin_if_fast,  ///< slips between particles that its speed draws apart: thinner than two sides
    thin,     ///< slips between them and out again: below 1.1 sides while the host moves it; else rods below
              ///< .55, balls below .8
    thinnest  ///< does not come out again: below two fifths of a side; edges that move
};

/// How a collider slips through cloth, depending on the length of triangles' sides. A step that stretches
/// cells to a multiple of their size lets colliders through that they would hold at rest.
struct Slipping {
    float thin = 0;           ///< radius, of a body half its width, and the thickness [m]
    bool is_ball = false;     ///< else a rod
    bool moves = false;       ///< by the host: no body is attached
    bool has_edges = false;   ///< that can part cloth, of what the host moves or leaves
    bool edges_move = false;  ///< enough to count whatever the cloth does
    float way = 0;            ///< greatest displacement of its points [m]

    /// Thinness of the round core beside sides of that length [m].
    [[nodiscard]] Thinness as_rod(float side) const;
    /// Edges part cloth that goes this way relative to the collider in h seconds [m], if this is true. Cloth
    /// does not come to rest on edges that count, so slow cloth does not meet those that stand still.
    [[nodiscard]] bool edges_part(float relative_way, float h) const {
        constexpr float fast = 1;  // [m/s]
        return has_edges && (edges_move || relative_way > fast * h);
    }
    /// Thinness of the whole collider.
    [[nodiscard]] Thinness beside(float side, bool edges_count) const {
        return edges_count ? Thinness::thinnest : as_rod(side);
    }
};
/// Nothing for a collider that is thick beside any triangle, or that has jumped.
[[nodiscard]] std::optional<Slipping> slipping(const ColliderMotion& motion, float h, float thickness);

/// The cores of one collider over a substep.
class Cores {
  public:
    static constexpr std::uint32_t most = 128, most_corners = HeldShape::most_edged_corners;

    /// No cores for planes, grounds, distance fields, and meshes that have neither a rod nor edges.
    Cores(const ColliderMotion& motion, float h, bool with_edges);

    [[nodiscard]] std::span<const Core> list() const { return std::span(cores_).first(count_); }
    [[nodiscard]] bool empty() const { return count_ == 0; }
    /// Whether the first core is a capsule's axis, along x from the local frame's origin, or a ball.
    [[nodiscard]] bool are_round() const { return are_round_; }
    /// Bounding box of all cores.
    [[nodiscard]] const Eigen::AlignedBox3f& box() const { return box_; }

    /// The bounding box, grown by `margin`, with its pose in the World at both ends.
    [[nodiscard]] TurningBox turning_box(float margin) const {
        return {to_own_,
                from_start_,
                origin_,
                start_origin_,
                box_.min() - Vector3::Constant(margin),
                box_.max() + Vector3::Constant(margin)};
    }
    /// Local coordinates of a point of the World at the substep's start, and at its end.
    [[nodiscard]] Vector3 seen_at_start(const Vector3& p) const { return from_start_ * (p - start_origin_); }
    [[nodiscard]] Vector3 seen(const Vector3& p) const { return to_own_ * (p - origin_); }
    [[nodiscard]] Vector3 place(const Vector3& own) const { return origin_ + in_world(own); }
    [[nodiscard]] Vector3 in_world(const Vector3& direction) const { return to_own_.transpose() * direction; }
    /// Velocity in the World, at the end, of a local point [m/s].
    [[nodiscard]] Vector3 velocity_at(const Vector3& own) const;
    /// Whether cloth can lie in this direction from a core's point: an edge's own body is in the way.
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
    Matrix3 gradient_;  // its gradient over local coordinates [1/s]
};

}  // namespace weft
