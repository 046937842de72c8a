#pragma once
// A rigid body over a part of a step.

#include <cmath>
#include <cstdint>

#include "collision/colliders/carried.h"
#include "collision/colliders/collider_contacts.h"
#include "engine/simd/symmetric3.h"
#include "engine/vector.h"
#include "weft/body.h"

namespace weft {

/// A velocity of a body and its angular one; or an impulse and its moment about the centre of mass.
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Of an impulse on what is at `arm` from the centre of mass.
[[nodiscard]] inline Vector6 wrench(const Eigen::Vector3d& arm, const Eigen::Vector3d& impulse) {
    Vector6 w;
    w << impulse, arm.cross(impulse);
    return w;
}

/// A^T g A, where A gives the velocity at `arm` of a body's: what a mass or a spring there is to the body.
[[nodiscard]] inline Matrix6 at_arm(const Eigen::Vector3d& arm, const Eigen::Matrix3d& g) {
    Eigen::Matrix3d x;
    x << 0, -arm.z(), arm.y(), arm.z(), 0, -arm.x(), -arm.y(), arm.x(), 0;
    Matrix6 sum;
    sum << g, -g * x, x * g, -x * g * x;
    return sum;
}

/// Turned about an axis of the World by the length of `turn` [rad].
[[nodiscard]] inline Eigen::Quaternionf turned(const Eigen::Quaternionf& rotation, const Vector3& turn) {
    const float angle = turn.norm();
    if (!(angle > 0)) return rotation;
    return (Eigen::Quaternionf(Eigen::AngleAxisf(angle, turn / angle)) * rotation).normalized();
}

/// All but its end is fixed while cloth is solved with it.
struct MovingBody {
    double inverse_mass = 0;                                    ///< [1/kg]
    Eigen::Vector3d inverse_inertia = Eigen::Vector3d::Zero();  ///< [1/(kg m^2)]
    float h = 0, gamma = 0;                                     ///< of the part, of its equation [s]
    double fastest = 1e9;  ///< neither it nor what is attached to it is faster [m/s]
    double reach = 0;      ///< from the centre of mass to the farthest particle attached to it [m]
    BodyPose start;        ///< of the part
    Vector6 velocity = Vector6::Zero();                  ///< likewise
    Vector6 drift = Vector6::Zero();                     ///< at its end, if cloth gave it nothing
    Eigen::Vector3d momentum = Eigen::Vector3d::Zero();  ///< its angular one then, if its inertia turns
    Vector6 free = Vector6::Zero();      ///< the same with what does not depend on the equation's solution
    Matrix6 root = Matrix6::Zero();      ///< its inverse mass is root root^T
    Vector6 expected = Vector6::Zero();  ///< to be given by cloth [N s, N m s]
    Vector6 now = Vector6::Zero();       ///< velocity at its end, as far as it is known
    BodyPose end;                        ///< likewise

    /// Whether an impulse changes how it moves.
    [[nodiscard]] bool gives_way() const { return inverse_mass > 0 || inverse_inertia.maxCoeff() > 0; }
    /// With its axes turned so.
    void set_root(const Eigen::Quaternionf& rotation) {
        const Eigen::Matrix3d axes = rotation.cast<double>().toRotationMatrix();
        root.setZero();
        root.topLeftCorner<3, 3>() = std::sqrt(inverse_mass) * Eigen::Matrix3d::Identity();
        root.bottomRightCorner<3, 3>() = axes * inverse_inertia.cwiseSqrt().asDiagonal();
    }
    /// `now` is what is expected.
    void expect() {
        now = free + root * (root.transpose() * expected);
        find_end();
    }
    /// Whether its inertia turns with it.
    [[nodiscard]] bool is_uneven() const {
        return inverse_inertia.minCoeff() > 0 && inverse_inertia.minCoeff() < inverse_inertia.maxCoeff();
    }
    /// Times an angular momentum: the angular velocity.
    [[nodiscard]] Eigen::Matrix3d inverse_inertia_at(const Eigen::Quaternionf& rotation) const {
        const Eigen::Matrix3d axes = rotation.cast<double>().toRotationMatrix();
        return axes * inverse_inertia.asDiagonal() * axes.transpose();
    }
    /// A velocity, or a way in `time` seconds, scaled down to what `fastest` allows.
    [[nodiscard]] Vector6 limited(const Vector6& way, double time = 1) const {
        const double most = time * fastest, length = way.head<3>().norm() + reach * way.tail<3>().norm();
        return length > most ? Vector6(way * (most / length)) : way;
    }
    /// As particles go that a collider holds: x + (h - gamma) v + gamma v', see History. What nothing touches
    /// turns at the mean of both ends, so that it keeps its energy.
    void find_end() {
        Vector6 way = static_cast<double>(h - gamma) * velocity + static_cast<double>(gamma) * now;
        way.tail<3>() = 0.5 * static_cast<double>(h) * (velocity + drift).tail<3>() +
                        static_cast<double>(gamma) * (now - drift).tail<3>();
        way = limited(way, static_cast<double>(h));
        end.position = start.position + way.head<3>().cast<float>();
        end.rotation = turned(start.rotation, way.tail<3>().cast<float>());
    }
    /// Of an uneven body with this momentum, if nothing touches it: the implicit midpoint rule.
    void turn_freely() {
        constexpr int rounds = 8;
        for (int round = 0; round < rounds; ++round) {
            const Eigen::Vector3d mean = 0.5 * (velocity + drift).tail<3>();
            const Eigen::Vector3d there =
                inverse_inertia_at(turned(start.rotation, h * mean.cast<float>())) * momentum;
            if (!there.allFinite()) return;
            drift.tail<3>() = there;
        }
    }
    /// Its inertia is that of where it is to end. Were it to turn on with the solution, a little that is
    /// given about one axis would come to much about another, and attached cloth would fly.
    void turn_inertia() {
        set_root(end.rotation);
        const Eigen::Vector3d there = inverse_inertia_at(end.rotation) * momentum;
        if (there.allFinite()) drift.tail<3>() = there;
    }
    /// As its inverse mass has it; nothing may keep it from turning.
    [[nodiscard]] Eigen::Matrix3d inertia() const {
        const Eigen::Matrix3d of_root = root.bottomRightCorner<3, 3>();
        return (of_root * of_root.transpose()).inverse();
    }
    /// From where it would come to its end at the velocity that it has there: surfaces move at that.
    [[nodiscard]] BodyPose swept_from() const {
        return {end.position - h * now.head<3>().cast<float>(),
                turned(end.rotation, -h * now.tail<3>().cast<float>())};
    }
    /// A collider that it carries, given in its frame.
    void move(const Collider& own, ColliderMotion& motion) const {
        motion.start = carried(own, swept_from());
        motion.end = carried(own, end);
        motion.centre = end.position;
        motion.velocity = now.head<3>().cast<float>();
        motion.spin = now.tail<3>().cast<float>();
    }
    [[nodiscard]] Vector3 velocity_at(const Vector3& point) const {
        return now.head<3>().cast<float>() + Vector3(now.tail<3>().cast<float>()).cross(point - end.position);
    }
};

/// A particle that goes with a body.
struct Attachment {
    std::uint32_t particle;
    std::uint32_t body;  ///< its number among the World's, in the present step
    Vector3 own;         ///< where, in the body's frame [m]
    BodyId id;
};

/// A particle that presses on a body or is attached to it, as last linearised.
struct BodyPush {
    std::uint32_t particle, body;
    Vector3 arm;       ///< from the centre of mass [m]
    Vector3 velocity;  ///< of the particle, where it was linearised [m/s]
};

/// A body's contact with a particle that does not give way, as last linearised: at the velocity u of the
/// body's point there the particle would get impulse + response (u - velocity), and the body gets the
/// opposite.
struct BodyStop {
    std::uint32_t body;
    Vector3 arm;          ///< from the centre of mass [m]
    Vector3 velocity;     ///< of the body's point, where it was linearised [m/s]
    Vector3 impulse;      ///< [N s]
    Symmetric3 response;  ///< [kg]
};

}  // namespace weft
