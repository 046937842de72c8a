#include "cloth/equation/moving_body.h"

#include <cmath>

namespace weft {

namespace {

/// The rotation, turned about the World's axis `turn` by that vector's length [rad].
Eigen::Quaternionf turned(const Eigen::Quaternionf& rotation, const Vector3& turn) {
    const float angle = turn.norm();
    if (!(angle > 0)) return rotation;
    return (Eigen::Quaternionf(Eigen::AngleAxisf(angle, turn / angle)) * rotation).normalized();
}

}  // namespace

Vector6 wrench(const Eigen::Vector3d& arm, const Eigen::Vector3d& impulse) {
    Vector6 w;
    w << impulse, arm.cross(impulse);
    return w;
}

Matrix6 at_arm(const Eigen::Vector3d& arm, const Eigen::Matrix3d& g) {
    Eigen::Matrix3d x;
    x << 0, -arm.z(), arm.y(), arm.z(), 0, -arm.x(), -arm.y(), arm.x(), 0;
    Matrix6 sum;
    sum << g, -g * x, x * g, -x * g * x;
    return sum;
}

bool MovingBody::gives_way() const {
    return inverse_mass > 0 || inverse_inertia.maxCoeff() > 0;
}

void MovingBody::set_root(const Eigen::Quaternionf& rotation) {
    const Eigen::Matrix3d axes = rotation.cast<double>().toRotationMatrix();
    root.setZero();
    root.topLeftCorner<3, 3>() = std::sqrt(inverse_mass) * Eigen::Matrix3d::Identity();
    root.bottomRightCorner<3, 3>() = axes * inverse_inertia.cwiseSqrt().asDiagonal();
}

void MovingBody::expect() {
    now = free + root * (root.transpose() * expected);
    find_end();
}

void MovingBody::stop(const Vector6& impulse) {
    const Vector6 change = root * (root.transpose() * impulse);
    drift += change;
    free += change;
    is_stopped = true;
    expect();
}

bool MovingBody::is_uneven() const {
    return inverse_inertia.minCoeff() > 0 && inverse_inertia.minCoeff() < inverse_inertia.maxCoeff();
}

Eigen::Matrix3d MovingBody::inverse_inertia_at(const Eigen::Quaternionf& rotation) const {
    const Eigen::Matrix3d axes = rotation.cast<double>().toRotationMatrix();
    return axes * inverse_inertia.asDiagonal() * axes.transpose();
}

Vector6 MovingBody::limited(const Vector6& way, double time) const {
    const double most = time * fastest, length = way.head<3>().norm() + reach * way.tail<3>().norm();
    return length > most ? Vector6(way * (most / length)) : way;
}

void MovingBody::find_end() {
    Vector6 way = static_cast<double>(h) * now;
    if (!is_stopped) {
        way = static_cast<double>(h - gamma) * velocity + static_cast<double>(gamma) * now;
        way.tail<3>() = turn + static_cast<double>(gamma) * (now - drift).tail<3>();
    }
    way = limited(way, static_cast<double>(h));
    end.position = start.position + way.head<3>().cast<float>();
    end.rotation = turned(start.rotation, way.tail<3>().cast<float>());
}

// Turns about one principal axis after the other, each by its own angular velocity, there and back (Touma and
// Wisdom 1994, "Lie-Poisson integrators for rigid body dynamics in the solar system"). An impulse before the
// part turns the body at half of the velocity that it gives.
void MovingBody::turn_freely() {
    constexpr double most_turn = 0.25;  // in a round [rad]
    constexpr int most_rounds = 256;
    const auto length = static_cast<double>(h);
    turn = 0.5 * length * (velocity + drift).tail<3>();
    if (!is_uneven()) return;
    momentum = inverse_inertia_at(start.rotation).inverse() * drift.tail<3>();
    const Eigen::Quaterniond begin = start.rotation.cast<double>();
    Eigen::Quaterniond rotation = begin;
    Eigen::Vector3d own = begin.conjugate() * momentum;
    const double twice_energy = own.dot(inverse_inertia.cwiseProduct(own));
    const double farthest = length * std::sqrt(twice_energy * inverse_inertia.maxCoeff());
    if (!std::isfinite(farthest)) return;
    const int rounds = 1 + static_cast<int>(std::min(farthest / most_turn, most_rounds - 1.0));
    const auto turn_about = [&](int axis, double share) {
        const double angle = share * length / rounds * inverse_inertia[axis] * own[axis];
        const Eigen::Quaterniond part(Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis)));
        rotation = rotation * part;
        own = part.conjugate() * own;
    };
    for (int round = 0; round < rounds; ++round) {
        turn_about(0, 0.5);
        turn_about(1, 0.5);
        turn_about(2, 1);
        turn_about(1, 0.5);
        turn_about(0, 0.5);
    }
    const Eigen::AngleAxisd gone(rotation * begin.conjugate());
    turn += gone.angle() * gone.axis() - length * drift.tail<3>();
    drift.tail<3>() = rotation * inverse_inertia.cwiseProduct(own);
}

void MovingBody::turn_inertia() {
    set_root(end.rotation);
    const Eigen::Vector3d there = inverse_inertia_at(end.rotation) * momentum;
    if (there.allFinite()) drift.tail<3>() = there;
}

Eigen::Matrix3d MovingBody::inertia() const {
    const Eigen::Matrix3d of_root = root.bottomRightCorner<3, 3>();
    return (of_root * of_root.transpose()).inverse();
}

BodyPose MovingBody::swept_from() const {
    return {end.position - h * now.head<3>().cast<float>(),
            turned(end.rotation, -h * now.tail<3>().cast<float>())};
}

void MovingBody::move(const Collider& own, ColliderMotion& motion) const {
    motion.start = carried(own, swept_from());
    motion.end = carried(own, end);
    motion.centre = end.position;
    motion.velocity = now.head<3>().cast<float>();
    motion.spin = now.tail<3>().cast<float>();
}

Vector3 MovingBody::velocity_at(const Vector3& point) const {
    return now.head<3>().cast<float>() + Vector3(now.tail<3>().cast<float>()).cross(point - end.position);
}

}  // namespace weft
