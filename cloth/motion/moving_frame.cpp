#include "cloth/motion/moving_frame.h"

#include <cmath>
#include <utility>

#include "cloth/state/state.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

namespace {

Eigen::Vector3d wide(const Vec3& v) {
    return to_vector(v).cast<double>();
}
Vec3 narrow(const Eigen::Vector3d& v) {
    return to_vec3(Vector3(v.cast<float>()));
}

void move_points(std::span<Vec4> points, const BlockRange& range, const RigidMotion& by) {
    if (points.empty()) return;
    for (std::uint32_t i = range.begin; i < range.end; ++i) set_xyz(points[i], by.point(xyz(points[i])));
}
void turn_vectors(std::span<Vec4> vectors, const BlockRange& range, const RigidMotion& by) {
    if (vectors.empty()) return;
    for (std::uint32_t i = range.begin; i < range.end; ++i) set_xyz(vectors[i], by.vector(xyz(vectors[i])));
}

/// Turns vectors about `common`: v <- common + A (v - common).
void turn_about(std::span<Vec4> vectors, const BlockRange& range, const RigidMotion& by,
                const Eigen::Vector3d& common) {
    if (vectors.empty()) return;
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
        const Eigen::Vector3d v = xyz(vectors[i]).cast<double>();
        set_xyz(vectors[i], (common + by.turn * (v - common)).cast<float>());
    }
}

void kick_outwards(const Carried& carried, const BlockRange& range, ClothState& state) {
    const Eigen::Vector3d& w = carried.spin;
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
        if (state.positions[i].w == 0) continue;
        const Eigen::Vector3d r = xyz(state.positions[i]).cast<double>() - carried.origin;
        const Eigen::Vector3d kick = carried.outwards * (w.squaredNorm() * r - w.dot(r) * w);
        set_xyz(state.velocities[i], xyz(state.velocities[i]) + kick.cast<float>());
    }
}

/// Moves positions, arrivals, contact normals and friction, but no velocities.
void move_cloth(const RigidMotion& by, const BlockRange& range, ClothState& state) {
    move_points(state.positions.span(), range, by);
    move_points(state.record.arrivals.span(), range, by);
    turn_vectors(state.held.normals.span(), range, by);
    turn_vectors(state.held.loads.span(), range, by);
}

/// Moves the cloth and its present skin, but not their targets.
void move_present(const RigidMotion& by, const BlockRange& range, ClothState& state) {
    move_cloth(by, range, state);
    move_points(state.skin.places.span(), range, by);
    turn_vectors(state.skin.normals.span(), range, by);
}

/// Moves velocities, normals, previous positions and BDF2's record.
void move_past(const RigidMotion& by, const BlockRange& range, ClothState& state) {
    move_points(state.previous_positions.span(), range, by);
    for (AlignedBuffer<Vec4>* vectors :
         {&state.velocities, &state.normals, &state.record.displacements, &state.record.velocity_changes})
        turn_vectors(vectors->span(), range, by);
}

}  // namespace

std::optional<RigidMotion> jump_of(const FrameState& frame, float distance, float angle, float dt) {
    if (!(distance > 0) && !(angle > 0)) return std::nullopt;
    const Eigen::Vector3d from = wide(frame.pose.translation), to = wide(frame.target.translation);
    const Eigen::Quaterniond turn =
        unit_quaternion(frame.target.rotation) * unit_quaternion(frame.pose.rotation).conjugate();
    const bool is_far = distance > 0 && (to - from).norm() > static_cast<double>(distance);
    const bool is_wide = angle > 0 && Eigen::AngleAxisd(turn).angle() > static_cast<double>(angle);
    if (!is_far && !is_wide) return std::nullopt;
    const Eigen::Vector3d goes_on = static_cast<double>(dt) * wide(frame.velocity);
    const Eigen::Matrix3d rotation = turn.toRotationMatrix();
    return RigidMotion{rotation, to - rotation * (from + goes_on)};
}

void jump(Parallel& parallel, const RigidMotion& by, ClothState& state) {
    for (Pin& pin : state.pins) {
        const Vector3 there = by.point(xyz(state.positions[pin.particle])), along = by.point(pin.target);
        if ((along - there).squaredNorm() < (pin.target - there).squaredNorm()) pin.target = along;
    }
    SkinState& skin = state.skin;
    const bool skin_goes_along = skin.is_still();
    parallel.ranges(state.size(), [&](const BlockRange& range) {
        move_present(by, range, state);
        move_past(by, range, state);
    });
    if (skin_goes_along) skin.keep_still();
    FrameState& frame = *state.frame;
    frame.pose = {by.point(frame.pose.translation), frame.target.rotation};
    frame.velocity = to_vec3(by.vector(to_vector(frame.velocity)));
    frame.velocity_change = to_vec3(by.vector(to_vector(frame.velocity_change)));
}

ActingMotion acting_motion(const FrameState& frame, const FrameInertia& inertia, float dt) {
    const Eigen::Vector3d from = wide(frame.pose.translation), way = wide(frame.target.translation) - from;
    const Eigen::AngleAxisd turn(unit_quaternion(frame.target.rotation) *
                                 unit_quaternion(frame.pose.rotation).conjugate());
    const double per_second = 1 / static_cast<double>(dt);
    return {(static_cast<double>(inertia.linear) * per_second * way).cast<float>(),
            (static_cast<double>(inertia.angular) * per_second * turn.angle() * turn.axis()).cast<float>(),
            (from + way).cast<float>()};
}

void limit_speeds(Parallel& parallel, const ActingMotion& of, float max_speed,
                  std::span<const Vec4> positions, std::span<Vec4> velocities) {
    parallel.ranges(static_cast<std::uint32_t>(positions.size()), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            if (!(positions[i].w > 0)) continue;
            const Vector3 common = of.velocity + of.spin.cross(xyz(positions[i]) - of.origin);
            const Vector3 own = xyz(velocities[i]) - common;
            const float speed = own.norm();
            if (speed > max_speed) set_xyz(velocities[i], common + max_speed / speed * own);
        }
    });
}

std::optional<Carried> carry_of(const FrameState& frame, const FrameInertia& inertia, float dt) {
    const auto h = static_cast<double>(dt), s = static_cast<double>(inertia.linear),
               e = static_cast<double>(inertia.angular), c = static_cast<double>(inertia.centrifugal);
    const Eigen::Vector3d from = wide(frame.pose.translation), way = wide(frame.target.translation) - from;
    const Rotation &a = frame.pose.rotation, &b = frame.target.rotation;
    const bool is_turned = a.x != b.x || a.y != b.y || a.z != b.z || a.w != b.w;
    const Eigen::AngleAxisd turn(is_turned ? unit_quaternion(b) * unit_quaternion(a).conjugate()
                                           : Eigen::Quaterniond::Identity());
    Carried carried;
    carried.moves = (s != 1 && !way.isZero(0)) || (e != 1 && is_turned);
    carried.outwards = is_turned ? h * (c - e * e) : 0;
    if (!carried.moves && carried.outwards == 0) return std::nullopt;
    carried.by.turn = Eigen::AngleAxisd((1 - e) * turn.angle(), turn.axis()).toRotationMatrix();
    carried.origin = from + (1 - s) * way;
    carried.by.shift = carried.origin - carried.by.turn * from;
    carried.velocity = s * wide(frame.velocity);
    carried.change = s * wide(frame.velocity_change);
    carried.spin = turn.angle() / h * turn.axis();
    return carried;
}

void carry(Parallel& parallel, const Carried& carried, ClothState& state) {
    StepRecord& record = state.record;
    const Eigen::Vector3d way = static_cast<double>(record.h) * carried.velocity;
    parallel.ranges(state.size(), [&](const BlockRange& range) {
        if (carried.moves) {
            move_present(carried.by, range, state);
            turn_about(state.velocities.span(), range, carried.by, carried.velocity);
            turn_about(record.displacements.span(), range, carried.by, way);
            turn_about(record.velocity_changes.span(), range, carried.by, carried.change);
        }
        if (carried.outwards != 0) kick_outwards(carried, range, state);
    });
}

void leave_start_behind(Parallel& parallel, const Carried& carried, ClothState& state) {
    if (!carried.moves) return;
    const RigidMotion back = carried.by.inverse();
    parallel.ranges(state.size(), [&](const BlockRange& range) {
        move_points(state.previous_positions.span(), range, back);
    });
}

void arrive(FrameState& frame, float dt, bool in_one_part, float max_speed) noexcept {
    const Eigen::Vector3d way = wide(frame.target.translation) - wide(frame.pose.translation);
    const double speed = way.norm() / static_cast<double>(dt), most = static_cast<double>(max_speed);
    const Eigen::Vector3d velocity = way / static_cast<double>(dt) * (speed > most ? most / speed : 1);
    // Pins change their velocity in the first part of a step. The record is of the last part, so it has that
    // change only in steps of one part.
    frame.velocity_change = in_one_part ? narrow(velocity - wide(frame.velocity)) : Vec3{};
    frame.velocity = narrow(velocity);
    frame.pose = frame.target;
}

void move_all(Parallel& parallel, const RigidMotion& by, ClothState& state) {
    parallel.ranges(state.size(), [&](const BlockRange& range) {
        move_present(by, range, state);
        move_past(by, range, state);
        move_points(state.skin.target_places.span(), range, by);
        turn_vectors(state.skin.target_normals.span(), range, by);
    });
    for (Pin& pin : state.pins) pin.target = by.point(pin.target);
    if (!state.frame) return;
    FrameState& frame = *state.frame;
    frame.pose = moved(frame.pose, by);
    frame.target = moved(frame.target, by);
    frame.velocity = to_vec3(by.vector(to_vector(frame.velocity)));
    frame.velocity_change = to_vec3(by.vector(to_vector(frame.velocity_change)));
}

void move_alone(Parallel& parallel, const RigidMotion& by, ClothState& state) {
    parallel.ranges(state.size(), [&](const BlockRange& range) {
        move_cloth(by, range, state);
        move_past(by, range, state);
    });
}

Collider moved(const Collider& collider, const RigidMotion& by) {
    const auto turned = [&](const Rotation& rotation) {
        return rotation_of(Eigen::Quaterniond(by.turn) * unit_quaternion(rotation));
    };
    Collider result = collider;
    std::visit(
        [&]<class Kind>(Kind& shape) {
            if constexpr (std::same_as<Kind, Sphere>) {
                shape.center = by.point(shape.center);
            } else if constexpr (std::same_as<Kind, Box>) {
                shape.center = by.point(shape.center);
                shape.rotation = turned(shape.rotation);
            } else if constexpr (std::same_as<Kind, PlacedShape>) {
                shape.position = by.point(shape.position);
                shape.rotation = turned(shape.rotation);
            } else if constexpr (std::same_as<Kind, Plane>) {
                const Eigen::Vector3d normal = by.turn * wide(shape.normal);
                shape.offset += static_cast<float>(normal.normalized().dot(by.shift));
                shape.normal = narrow(normal);
            } else {
                shape.a = by.point(shape.a);
                shape.b = by.point(shape.b);
            }
        },
        result.shape);
    return result;
}

}  // namespace weft
