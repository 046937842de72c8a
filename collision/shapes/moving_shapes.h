#pragma once
// Collider shapes over a substep, as the kernels read them, and the broad phase against blocks of particles.

#include <limits>
#include <optional>
#include <variant>

#include "collision/shapes/collider_motion.h"
#include "collision/shapes/held_shape.h"
#include "engine/vector.h"
#include "weft/collider.h"
#include "weft/types.h"

namespace weft {

/// A capsule, or a sphere (axis 0), at a substep's end, with its motion over the substep.
struct MovingCapsule {
    Vector3 a, axis;               ///< [m]; from a to b
    float per_length_squared;      ///< 1 / axis^2; 0 for a sphere
    float radius;                  ///< [m]
    float growth;                  ///< rate of change of the radius [m/s]
    Vector3 velocity, difference;  ///< velocity of a, and that of b less it [m/s]
    Vector3 across;                ///< surface normal for a point on the axis
    Vector3 start_a, start_axis;   ///< at the substep's start [m]
    float per_start_length_squared;
    float start_radius;  ///< [m]
    Matrix3 turn;        ///< rotation of the axis over the substep
};

/// A tapered capsule. The radii above are those of the ball about a; these fields are b's less a's.
struct MovingTaperedCapsule : MovingCapsule {
    float wider, wider_at_start;  ///< [m]
    float faster;                 ///< difference of growth [m/s]
    float tilt;         ///< fraction of the nearest ball less the foot's, per distance from the axis [1/m]
    float first, last;  ///< range of that fraction; equal where one end's ball contains the other's
};

/// A half space normal . p <= offset at a substep's end. Its surface moves along the normal, at p by (advance
/// - turn . p) [m/s]. Sliding within the plane cannot be derived from its two ends.
struct MovingPlane {
    Vector3 normal;
    float offset;   ///< [m]
    float advance;  ///< [m/s]
    Vector3 turn;   ///< [1/s]
    float fastest;  ///< [m/s]
    float h;        ///< length of the substep [s]
};

/// A shape's local frame at a substep's end, with its motion over the substep.
struct MovingSpace {
    Vector3 origin, start_origin;  ///< [m]
    Matrix3 to_own, to_own_at_start, from_own;
    Vector3 velocity;  ///< velocity of the origin [m/s]
    Matrix3 spin;      ///< a point at p moves at velocity + spin (p - origin) [1/s]
    float fastest;     ///< [m/s]
};

/// A box centred at the origin of its local frame.
struct MovingBox {
    MovingSpace space;
    Vector3 half;    ///< half extents [m]
    Vector3 wider;   ///< half extents less those at the start [m]
    Vector3 growth;  ///< rate of change of the half extents [m/s]
};

/// An instance of a shape that the World holds, at one end of a substep. Both ends have the same shape.
struct HeldInstance {
    const PlacedShape& place;
    const HeldShape& shape;
    float rate;  ///< see ColliderMotion
};
struct MovingHeld {
    MovingSpace space;
    const HeldShape* shape;
    float rate;
};

using MovingShape = std::variant<MovingCapsule, MovingTaperedCapsule, MovingPlane, MovingBox, MovingHeld>;

/// Motion of a block's particles: the bounding box of their ends, and the greatest displacement.
struct BlockPaths {
    Bounds ends;
    float longest;  ///< [m]
};

/// A substep's length, and the greatest speed that a collider gives to particles in it.
struct Pace {
    float h, fastest;  // [s], [m/s]
};

/// Search distance of a block's particles: the contact thickness and a margin beyond it.
struct Reach {
    float thickness, beyond;  // [m]
    [[nodiscard]] float all() const { return thickness + beyond; }
};

/// A shape's motion from `start` to `end` [m]. `thin`: a particle with a longer displacement relative to it
/// can pass through. `way`: the greatest displacement of its points; negative where nothing is swept, because
/// it has jumped or has no far side. `travel`: displacement of its centre.
struct Sweeping {
    float thin, way;
    Vector3 travel;
    float thin_as_a_whole = thin;  ///< for parts_to_meet(): a held shape counts as its bounding box
};
[[nodiscard]] Sweeping sweeping(const Capsule& start, const Capsule& end, const Pace& pace, float thickness);
[[nodiscard]] Sweeping sweeping(const TaperedCapsule& start, const TaperedCapsule& end, const Pace& pace,
                                float thickness);
[[nodiscard]] Sweeping sweeping(const Plane& start, const Plane& end, const Pace& pace, float thickness);
[[nodiscard]] Sweeping sweeping(const Box& start, const Box& end, const Pace& pace, float thickness);
[[nodiscard]] Sweeping sweeping(const HeldInstance& start, const HeldInstance& end, const Pace& pace,
                                float thickness);

/// `thin`: see ContactSettings. `way`: the greatest displacement of particles relative to the shape [m]. Both
/// are 0 where no path needs a sweep.
struct Meeting {
    float thin = 0, way = 0;
};

/// The broad phase, first and cheapest: nothing if the shape is farther than the reach from the block's
/// paths. Paths that are not numbers are never excluded.
[[nodiscard]] std::optional<Meeting> may_meet(const Capsule& start, const Capsule& end, const Pace& pace,
                                              const Reach& reach, const BlockPaths& paths);
[[nodiscard]] std::optional<Meeting> may_meet(const TaperedCapsule& start, const TaperedCapsule& end,
                                              const Pace& pace, const Reach& reach, const BlockPaths& paths);
[[nodiscard]] std::optional<Meeting> may_meet(const Plane& start, const Plane& end, const Pace& pace,
                                              const Reach& reach, const BlockPaths& paths);
[[nodiscard]] std::optional<Meeting> may_meet(const Box& start, const Box& end, const Pace& pace,
                                              const Reach& reach, const BlockPaths& paths);
[[nodiscard]] std::optional<Meeting> may_meet(const HeldInstance& start, const HeldInstance& end,
                                              const Pace& pace, const Reach& reach, const BlockPaths& paths);

/// Whether the collider's centre exceeds ColliderMotion::fastest within h seconds: it then jumps. A plane has
/// no centre and never jumps.
[[nodiscard]] bool has_jumped(const ColliderMotion& motion, float h);

/// Whether a collider may be met, by ColliderMotion::filled: false only where may_meet() returns nothing.
[[nodiscard]] inline bool may_be_near(const ColliderMotion& motion, float reach_of_cloth,
                                      const BlockPaths& paths) {
    return !are_apart(motion.filled, grown(paths.ends, paths.longest + reach_of_cloth));
}
/// ColliderMotion::filled, computed from both ends; `everywhere` for a plane.
[[nodiscard]] Bounds filled_by(const ColliderMotion& motion);

[[nodiscard]] MovingCapsule moving(const Capsule& start, const Capsule& end, const Pace& pace);
[[nodiscard]] MovingTaperedCapsule moving(const TaperedCapsule& start, const TaperedCapsule& end,
                                          const Pace& pace);
[[nodiscard]] MovingPlane moving(const Plane& start, const Plane& end, const Pace& pace);
[[nodiscard]] MovingBox moving(const Box& start, const Box& end, const Pace& pace);
[[nodiscard]] MovingHeld moving(const HeldInstance& start, const HeldInstance& end, const Pace& pace);

[[nodiscard]] inline Capsule as_capsule(const Sphere& sphere) {
    return {sphere.center, sphere.center, sphere.radius};
}

struct UnitPlane {
    Vector3 normal;
    float offset;
};
[[nodiscard]] UnitPlane unit(const Plane& plane);
/// The rotation as a unit quaternion.
[[nodiscard]] Eigen::Quaternionf unit(const Rotation& rotation);

/// Calls use(start, end) with a collider's shape at both ends of a substep: a sphere as a capsule, a placed
/// shape as an instance.
template <class Use>
auto with_shapes(const ColliderMotion& motion, const Use& use) {
    return std::visit(
        [&]<class Kind>(const Kind& end) {
            const Kind& start = *std::get_if<Kind>(&motion.start.shape);
            if constexpr (std::is_same_v<Kind, Sphere>)
                return use(as_capsule(start), as_capsule(end));
            else if constexpr (std::is_same_v<Kind, PlacedShape>)
                return use(HeldInstance{start, *motion.held, motion.rate},
                           HeldInstance{end, *motion.held, motion.rate});
            else
                return use(start, end);
        },
        motion.end.shape);
}

}  // namespace weft
