#pragma once
// Shapes of colliders over a substep, as the kernels read them; and which blocks of particles may meet one.

#include <limits>
#include <optional>

#include "collision/shapes/collider_motion.h"
#include "collision/shapes/held_shape.h"
#include "engine/vector.h"
#include "weft/collider.h"
#include "weft/types.h"

namespace weft {

/// A capsule, or a sphere (axis 0), at a substep's end, and how it comes there.
struct MovingCapsule {
    Vector3 a, axis;               ///< [m]; from a to b
    float per_length_squared;      ///< 1 / axis^2; 0 for a sphere
    float radius;                  ///< [m]
    float growth;                  ///< of the radius [m/s]
    Vector3 velocity, difference;  ///< of a, and what b's is more [m/s]
    Vector3 across;                ///< the way out for a point on the axis
    Vector3 start_a, start_axis;   ///< at the substep's start [m]
    float per_start_length_squared;
    float start_radius;  ///< [m]
    Matrix3 turn;        ///< from then to now
};

/// The radii above are of the ball about a; what they are more at b.
struct MovingTaperedCapsule : MovingCapsule {
    float wider, wider_at_start;  ///< [m]
    float faster;                 ///< growth [m/s]
    float tilt;  ///< the nearest ball is farther along than the foot on the axis, by this and the distance
    float first, last;  ///< fractions of the axis within which that is; equal where one ball holds all
};

/// A half space normal . p <= offset at a substep's end. Its surface moves along the normal, at p by
/// (advance - turn . p): how it slides in itself cannot be told from its two ends.
struct MovingPlane {
    Vector3 normal;
    float offset;   ///< [m]
    float advance;  ///< [m/s]
    Vector3 turn;   ///< [1/s]
    float fastest;  ///< [m/s]
    float h;        ///< of the substep [s]
};

/// A space of a shape's own at a substep's end, and how it comes there.
struct MovingSpace {
    Vector3 origin, start_origin;  ///< [m]
    Matrix3 to_own, to_own_at_start, from_own;
    Vector3 velocity;  ///< of the origin [m/s]
    Matrix3 spin;      ///< what is at p goes by velocity + spin (p - origin) [1/s]
    float fastest;     ///< [m/s]
};

/// A box about the origin of its own space.
struct MovingBox {
    MovingSpace space;
    Vector3 half;    ///< along each axis [m]
    Vector3 wider;   ///< than at the start [m]
    Vector3 growth;  ///< of the same [m/s]
};

/// An instance of a shape that the World holds, at one end of a substep; at both the same shape.
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

/// Where a block's particles end, and how far the farthest has gone.
struct BlockPaths {
    Bounds ends;
    float longest;  ///< [m]
};

/// A substep, and the speed that a collider has in it at most.
struct Pace {
    float h, fastest;  // [s], [m/s]
};

/// How far a block's particles see: thickness and what is beyond it.
struct Reach {
    float thickness, beyond;  // [m]
    [[nodiscard]] float all() const { return thickness + beyond; }
};

/// Of a shape that moves from `start` to `end`: `thin`, where particles that move farther against it can pass
/// it; `way`, how far its points go at most, below 0 where it has jumped and sweeps nothing; `travel` of its
/// middle [m].
struct Sweeping {
    float thin, way;
    Vector3 travel;
    float thin_as_a_whole = thin;  ///< for parts_to_meet()
};
[[nodiscard]] Sweeping sweeping(const Capsule& start, const Capsule& end, const Pace& pace, float thickness);
[[nodiscard]] Sweeping sweeping(const TaperedCapsule& start, const TaperedCapsule& end, const Pace& pace,
                                float thickness);
[[nodiscard]] Sweeping sweeping(const Plane& start, const Plane& end, const Pace& pace, float thickness);
[[nodiscard]] Sweeping sweeping(const Box& start, const Box& end, const Pace& pace, float thickness);
[[nodiscard]] Sweeping sweeping(const HeldInstance& start, const HeldInstance& end, const Pace& pace,
                                float thickness);

/// `thin`: see ContactSettings; `way`: how far particles go against the shape at most, if it is not 0 [m].
struct Meeting {
    float thin = 0, way = 0;
};

/// Nothing where the shape is clear of the block's paths by more than the reach: first and cheapest. Paths
/// that are not numbers are clear of nothing.
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

/// Whether the collider's middle goes faster within h seconds than anything may: then it jumps. A plane,
/// which has none, never does.
[[nodiscard]] bool has_jumped(const ColliderMotion& motion, float h);

/// Where a collider may be met, by ColliderMotion::filled: false only where may_meet() has nothing.
[[nodiscard]] inline bool may_be_near(const ColliderMotion& motion, float reach_of_cloth,
                                      const BlockPaths& paths) {
    return !are_apart(motion.filled, grown(paths.ends, paths.longest + reach_of_cloth));
}
/// ColliderMotion::filled of the ends as they are; everywhere, if the shape has no end.
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
/// Of unit length, too.
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
