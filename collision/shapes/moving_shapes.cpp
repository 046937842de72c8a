#include "collision/shapes/moving_shapes.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "engine/bounds.h"
#include "engine/least_turn.h"

namespace weft {

namespace {

Vector3 velocity(const Vec3& from, const Vec3& to, const Pace& pace) {
    const Vector3 way = to_vector(to) - to_vector(from);
    const float length = way.norm();
    return length > pace.fastest * pace.h ? Vector3(way * (pace.fastest / length)) : Vector3(way / pace.h);
}

float limited(float speed, const Pace& pace) {
    return std::clamp(speed, -pace.fastest, pace.fastest);
}

/// The least rotation from one direction to another; none if either has no length.
Matrix3 turn_between(const Vector3& from, const Vector3& to) {
    const float lengths = std::sqrt(from.squaredNorm() * to.squaredNorm());
    if (!(lengths > 0 && lengths < std::numeric_limits<float>::infinity())) return Matrix3::Identity();
    return least_turn(from, to).toRotationMatrix();
}

float way_of(const Vec3& from, const Vec3& to) {
    return (to_vector(to) - to_vector(from)).norm();
}

Vector3 middle_of(const Vec3& a, const Vec3& b) {
    return 0.5f * (to_vector(a) + to_vector(b));
}

/// `way`, or minus infinity beyond the speed limit, where the shape has jumped.
float unless_jumped(float way, const Pace& pace) {
    return way > pace.fastest * pace.h ? -std::numeric_limits<float>::infinity() : way;
}

Meeting meeting_of(const Sweeping& sweep, const BlockPaths& paths) {
    return {sweep.thin, sweep.way + paths.longest};
}

// are_clear(): whether a shape is farther than `reach` from everything within the bounds.

/// Tests the whole sweep: both ends of the axis move along straight lines.
bool are_clear(const Capsule& start, const Capsule& end, float reach, const Bounds& bounds) {
    const float far = std::max(start.radius, end.radius) + reach;
    const auto apart = [far](const Vec3& a0, const Vec3& b0, const Vec3& a1, const Vec3& b1,
                             const Bounds& box, float Vec3::*axis) {
        return std::min({a0.*axis, b0.*axis, a1.*axis, b1.*axis}) - far > box.upper.*axis ||
               std::max({a0.*axis, b0.*axis, a1.*axis, b1.*axis}) + far < box.lower.*axis;
    };
    return apart(start.a, start.b, end.a, end.b, bounds, &Vec3::x) ||
           apart(start.a, start.b, end.a, end.b, bounds, &Vec3::y) ||
           apart(start.a, start.b, end.a, end.b, bounds, &Vec3::z);
}

bool are_clear(const UnitPlane& plane, float reach, const Bounds& bounds) {
    const Vector3 nearest =
        (plane.normal.array() > 0).select(to_vector(bounds.lower), to_vector(bounds.upper));
    return plane.normal.dot(nearest) - plane.offset > reach;
}

/// Position and orientation of a local frame.
struct Pose {
    Vector3 origin;
    Matrix3 to_own;

    Pose(const Vec3& position, const Rotation& rotation)
        : origin(to_vector(position)), to_own(unit(rotation).toRotationMatrix().transpose()) {}
};

/// The bounding box, in a local frame, of a box in the World.
Eigen::AlignedBox3f seen_from(const Pose& pose, const Bounds& bounds) {
    const Vector3 lower = to_vector(bounds.lower), upper = to_vector(bounds.upper);
    const Vector3 middle = pose.to_own * (0.5f * (lower + upper) - pose.origin);
    const Vector3 half = pose.to_own.cwiseAbs() * (0.5f * (upper - lower));
    return {middle - half, middle + half};
}

bool are_apart(const Eigen::AlignedBox3f& a, const Eigen::AlignedBox3f& b, float reach) {
    return (a.min().array() - reach > b.max().array()).any() ||
           (a.max().array() + reach < b.min().array()).any();
}

/// Bounding boxes of a shape in its local frame.
struct Filling {
    Eigen::AlignedBox3f at_start, at_end;
};

/// In the shape's moving frame a path is straight, from its start in the frame at the start to its end.
std::optional<Meeting> may_meet(const Pose& start, const Pose& end, const Filling& filling,
                                const Sweeping& sweep, const Reach& reach, const BlockPaths& paths) {
    const Eigen::AlignedBox3f ends = seen_from(end, paths.ends);
    const bool may_pass = sweep.way + paths.longest > sweep.thin;
    if (!may_pass)
        return are_apart(ends, filling.at_end, reach.all()) ? std::nullopt : std::optional(Meeting{});
    const Eigen::AlignedBox3f way = ends.merged(seen_from(start, grown(paths.ends, paths.longest)));
    if (are_apart(way, filling.at_end.merged(filling.at_start), reach.all())) return std::nullopt;
    return meeting_of(sweep, paths);
}

/// Greatest displacement, by the frame's motion, of points within `radius` of its origin.
float way_of_space(const Vec3& from, const Vec3& to, const Rotation& start, const Rotation& end,
                   float radius) {
    return way_of(from, to) + radius * unit(start).angularDistance(unit(end));
}

MovingSpace moving_space(const Vec3& start, const Rotation& start_rotation, const Vec3& end,
                         const Rotation& end_rotation, const Pace& pace) {
    const Pose from(start, start_rotation), to(end, end_rotation);
    const Matrix3 from_own = to.to_own.transpose();
    // A frame that does not turn must get no spin from rounding.
    const bool turns = from.to_own != to.to_own;
    const Matrix3 back = turns ? Matrix3(from.to_own.transpose() * to.to_own) : Matrix3::Identity();
    return {.origin = to.origin,
            .start_origin = from.origin,
            .to_own = to.to_own,
            .to_own_at_start = from.to_own,
            .from_own = from_own,
            .velocity = (to.origin - from.origin) / pace.h,
            .spin = (Matrix3::Identity() - back) / pace.h,
            .fastest = pace.fastest};
}

Eigen::AlignedBox3f filled(const Box& box) {
    const Vector3 half = to_vector(box.half_extents);
    return {-half, half};
}

/// Radius of the ball about the origin that contains the box.
float radius_of(const Eigen::AlignedBox3f& box) {
    return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).norm();
}

/// Tests the ball about the centre of rotation, which contains the shape at any orientation.
bool are_clear(const Vec3& start, const Vec3& end, float radius, const Reach& reach,
               const BlockPaths& paths) {
    return are_clear(Capsule{start, start, radius}, Capsule{end, end, radius}, reach.all(),
                     grown(paths.ends, paths.longest));
}

Capsule widest(const TaperedCapsule& shape) {
    return {shape.a, shape.b, std::max(shape.radius_a, shape.radius_b)};
}

/// Bounding box of a capsule's sweep, grown by `thickness` and by more than rounding.
Bounds around(const Capsule& start, const Capsule& end, float thickness) {
    Eigen::AlignedBox3f box(to_vector(start.a));
    for (const Vec3& point : {start.b, end.a, end.b}) box.extend(to_vector(point));
    const float farthest = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
    const float margin = std::max(start.radius, end.radius) + thickness + 0x1p-20f * farthest;
    return grown({to_vec3(box.min()), to_vec3(box.max())}, 1.001f * margin);
}

// filled(): the swept bounding box, for each kind of shape; see filled_by().
Bounds filled(const Capsule& start, const Capsule& end, float thickness) {
    return around(start, end, thickness);
}
Bounds filled(const TaperedCapsule& start, const TaperedCapsule& end, float thickness) {
    return around(widest(start), widest(end), thickness);
}
Bounds filled(const Plane&, const Plane&, float) {
    return everywhere;
}
Bounds filled(const Box& start, const Box& end, float thickness) {
    const float radius = std::max(to_vector(start.half_extents).norm(), to_vector(end.half_extents).norm());
    return around({start.center, start.center, radius}, {end.center, end.center, radius}, thickness);
}
Bounds filled(const HeldInstance& start, const HeldInstance& end, float thickness) {
    const float radius = radius_of(end.shape.box());
    const Vec3 &from = start.place.position, &to = end.place.position;
    return around({from, from, radius}, {to, to, radius}, thickness);
}

}  // namespace

bool has_jumped(const ColliderMotion& motion, float h) {
    return with_shapes(motion, [&](const auto& start, const auto& end) {
        return sweeping(start, end, {h, motion.fastest}, 0).travel.norm() > motion.fastest * h;
    });
}

Bounds filled_by(const ColliderMotion& motion) {
    return with_shapes(
        motion, [&](const auto& start, const auto& end) { return filled(start, end, motion.end.thickness); });
}

UnitPlane unit(const Plane& plane) {
    return {to_vector(plane.normal).stableNormalized(), plane.offset};
}

Eigen::Quaternionf unit(const Rotation& rotation) {
    return Eigen::Quaternionf(rotation.w, rotation.x, rotation.y, rotation.z).normalized();
}

/// A particle that moves by less than `thin` against a capsule ends within 30 degrees of where it entered.
Sweeping sweeping(const Capsule& start, const Capsule& end, const Pace& pace, float thickness) {
    const float way =
        std::max(way_of(start.a, end.a), way_of(start.b, end.b)) + std::abs(end.radius - start.radius);
    return {.thin = 0.5f * (end.radius + thickness),
            .way = unless_jumped(way, pace),
            .travel = middle_of(end.a, end.b) - middle_of(start.a, start.b)};
}

Sweeping sweeping(const TaperedCapsule& start, const TaperedCapsule& end, const Pace& pace, float thickness) {
    const float way = std::max(way_of(start.a, end.a) + std::abs(end.radius_a - start.radius_a),
                               way_of(start.b, end.b) + std::abs(end.radius_b - start.radius_b));
    return {.thin = 0.5f * (std::min(end.radius_a, end.radius_b) + thickness),
            .way = unless_jumped(way, pace),
            .travel = middle_of(end.a, end.b) - middle_of(start.a, start.b)};
}

/// A plane has no far side: a particle that has passed it is inside, and no path needs a sweep.
Sweeping sweeping(const Plane&, const Plane&, const Pace&, float) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    return {.thin = infinity, .way = -infinity, .travel = Vector3::Zero()};
}

Sweeping sweeping(const Box& start, const Box& end, const Pace& pace, float thickness) {
    const Vector3 half = to_vector(end.half_extents), before = to_vector(start.half_extents);
    const float way = way_of_space(start.center, end.center, start.rotation, end.rotation, half.norm()) +
                      (half - before).norm();
    return {.thin = 0.5f * (half.minCoeff() + thickness),
            .way = unless_jumped(way, pace),
            .travel = to_vector(end.center) - to_vector(start.center)};
}

// Paths longer than half the thickness are swept, because a mesh may have no thickness of its own. Ground has
// no far side.
Sweeping sweeping(const HeldInstance& start, const HeldInstance& end, const Pace& pace, float thickness) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const PlacedShape &from = start.place, &to = end.place;
    const Vector3 travel = to_vector(to.position) - to_vector(from.position);
    if (end.shape.is_ground()) return {.thin = infinity, .way = -infinity, .travel = travel};
    const Eigen::AlignedBox3f& box = end.shape.box();
    const float way = way_of_space(from.position, to.position, from.rotation, to.rotation, radius_of(box));
    return {.thin = std::max(0.5f * thickness, 5e-4f),
            .way = unless_jumped(way, pace),
            .travel = travel,
            .thin_as_a_whole = 0.5f * (0.5f * box.sizes().minCoeff() + thickness)};
}

std::optional<Meeting> may_meet(const Capsule& start, const Capsule& end, const Pace& pace,
                                const Reach& reach, const BlockPaths& paths) {
    if (are_clear(start, end, reach.all(), grown(paths.ends, paths.longest))) return std::nullopt;
    const Sweeping sweep = sweeping(start, end, pace, reach.thickness);
    if (sweep.way + paths.longest > sweep.thin) return meeting_of(sweep, paths);
    return are_clear(end, end, reach.all(), paths.ends) ? std::nullopt : std::optional(Meeting{});
}

std::optional<Meeting> may_meet(const TaperedCapsule& start, const TaperedCapsule& end, const Pace& pace,
                                const Reach& reach, const BlockPaths& paths) {
    const Capsule from = widest(start), to = widest(end);
    if (are_clear(from, to, reach.all(), grown(paths.ends, paths.longest))) return std::nullopt;
    const Sweeping sweep = sweeping(start, end, pace, reach.thickness);
    if (sweep.way + paths.longest > sweep.thin) return meeting_of(sweep, paths);
    return are_clear(to, to, reach.all(), paths.ends) ? std::nullopt : std::optional(Meeting{});
}

std::optional<Meeting> may_meet(const Plane&, const Plane& end, const Pace&, const Reach& reach,
                                const BlockPaths& paths) {
    return are_clear(unit(end), reach.all(), paths.ends) ? std::nullopt : std::optional(Meeting{});
}

std::optional<Meeting> may_meet(const Box& start, const Box& end, const Pace& pace, const Reach& reach,
                                const BlockPaths& paths) {
    const float radius = std::max(to_vector(start.half_extents).norm(), to_vector(end.half_extents).norm());
    if (are_clear(start.center, end.center, radius, reach, paths)) return std::nullopt;
    return may_meet(Pose(start.center, start.rotation), Pose(end.center, end.rotation),
                    {filled(start), filled(end)}, sweeping(start, end, pace, reach.thickness), reach, paths);
}

std::optional<Meeting> may_meet(const HeldInstance& start, const HeldInstance& end, const Pace& pace,
                                const Reach& reach, const BlockPaths& paths) {
    const Eigen::AlignedBox3f& box = end.shape.box();
    if (are_clear(start.place.position, end.place.position, radius_of(box), reach, paths))
        return std::nullopt;
    return may_meet(Pose(start.place.position, start.place.rotation),
                    Pose(end.place.position, end.place.rotation), {box, box},
                    sweeping(start, end, pace, reach.thickness), reach, paths);
}

MovingCapsule moving(const Capsule& start, const Capsule& end, const Pace& pace) {
    const Vector3 axis = to_vector(end.b) - to_vector(end.a);
    const Vector3 start_axis = to_vector(start.b) - to_vector(start.a);
    const Vector3 velocity_a = velocity(start.a, end.a, pace), velocity_b = velocity(start.b, end.b, pace);
    // An axis shorter than rounding of its radius counts as none: the inverse of its square may overflow.
    const auto per_square = [](const Vector3& v, float radius) {
        const float squared = v.squaredNorm();
        return squared > 1e-12f * radius * radius ? 1 / squared : 0;
    };
    const float per_length_squared = per_square(axis, end.radius);
    const bool is_sphere = per_length_squared == 0;
    return {.a = to_vector(end.a),
            .axis = axis,
            .per_length_squared = per_length_squared,
            .radius = end.radius,
            .growth = limited((end.radius - start.radius) / pace.h, pace),
            .velocity = velocity_a,
            .difference = velocity_b - velocity_a,
            .across = is_sphere ? Vector3::UnitY() : axis.unitOrthogonal(),
            .start_a = to_vector(start.a),
            .start_axis = start_axis,
            .per_start_length_squared = per_square(start_axis, start.radius),
            .start_radius = start.radius,
            .turn = turn_between(start_axis, axis)};
}

// The ball at s along the axis has the radius r + k s, |k| < 1. The ball nearest to a point at distance y
// from the axis is k y / sqrt(1 - k^2) beyond the point's foot on the axis.
MovingTaperedCapsule moving(const TaperedCapsule& start, const TaperedCapsule& end, const Pace& pace) {
    const auto capsule = [](const TaperedCapsule& shape) {
        return Capsule{shape.a, shape.b, shape.radius_a};
    };
    MovingTaperedCapsule made{moving(capsule(start), capsule(end), pace), 0, 0, 0, 0, 0, 1};
    made.wider = end.radius_b - end.radius_a;
    made.wider_at_start = start.radius_b - start.radius_a;
    made.faster = limited((end.radius_b - start.radius_b) / pace.h, pace) - made.growth;
    const float length = made.per_length_squared > 0 ? made.axis.norm() : 0.0f;
    if (std::abs(made.wider) < 0.9999f * length) {
        const float k = made.wider / length, cosine = std::sqrt(1 - k * k);
        made.tilt = k / (cosine * length);
        made.across = cosine * made.across - (k / length) * made.axis;
    } else {
        made.first = made.last = made.wider > 0 ? 1.0f : 0.0f;
    }
    return made;
}

MovingPlane moving(const Plane& start, const Plane& end, const Pace& pace) {
    const UnitPlane from = unit(start), to = unit(end);
    return {.normal = to.normal,
            .offset = to.offset,
            .advance = (to.offset - from.offset) / pace.h,
            .turn = (to.normal - from.normal) / pace.h,
            .fastest = pace.fastest,
            .h = pace.h};
}

MovingBox moving(const Box& start, const Box& end, const Pace& pace) {
    const Vector3 half = to_vector(end.half_extents), wider = half - to_vector(start.half_extents);
    return {.space = moving_space(start.center, start.rotation, end.center, end.rotation, pace),
            .half = half,
            .wider = wider,
            .growth = (wider / pace.h).cwiseMax(-pace.fastest).cwiseMin(pace.fastest)};
}

MovingHeld moving(const HeldInstance& start, const HeldInstance& end, const Pace& pace) {
    return {moving_space(start.place.position, start.place.rotation, end.place.position, end.place.rotation,
                         pace),
            &end.shape, end.rate};
}

}  // namespace weft
