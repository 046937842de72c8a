#pragma once
// A rigid body over a part of a step.

#include <cmath>
#include <cstdint>

#include "collision/carried.h"
#include "collision/collider_contacts.h"
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

/// Turned about an axis of the World by the length of `turn` [rad].
[[nodiscard]] inline Eigen::Quaternionf turned(const Eigen::Quaternionf& rotation, const Vector3& turn) {
    const float angle = turn.norm();
    if (!(angle > 0)) return rotation;
    return (Eigen::Quaternionf(Eigen::AngleAxisf(angle, turn / angle)) * rotation).normalized();
}

/// All but its end is fixed while cloth is solved with it.
struct MovingBody {
    double inverse_mass = 0;                                           ///< [1/kg]
    Eigen::Vector3d inverse_inertia = Eigen::Vector3d::Zero();         ///< [1/(kg m^2)]
    float h = 0, gamma = 0;                                            ///< of the part, of its equation [s]
    BodyPose start;                                                    ///< of the part
    Vector6 velocity = Vector6::Zero();                                ///< likewise
    Vector6 drift = Vector6::Zero();  ///< at its end, if cloth gave it nothing
    Vector6 free = Vector6::Zero();   ///< the same with what does not depend on the equation's solution
    Matrix6 root = Matrix6::Zero();   ///< its inverse mass is root root^T
    Vector6 expected = Vector6::Zero();  ///< to be given by cloth [N s, N m s]
    Vector6 now = Vector6::Zero();    ///< velocity at its end, as far as it is known
    BodyPose end;                     ///< likewise

    void set_root() {
        const Eigen::Matrix3d axes = start.rotation.cast<double>().toRotationMatrix();
        root.setZero();
        root.topLeftCorner<3, 3>() = std::sqrt(inverse_mass) * Eigen::Matrix3d::Identity();
        root.bottomRightCorner<3, 3>() = axes * inverse_inertia.cwiseSqrt().asDiagonal();
    }
    /// `now` is what is expected.
    void expect() {
        now = free + root * (root.transpose() * expected);
        find_end();
    }
    /// As particles go that a collider holds: x + (h - gamma) v + gamma v', see History.
    void find_end() {
        const Vector6 way = static_cast<double>(h - gamma) * velocity + static_cast<double>(gamma) * now;
        end.position = start.position + way.head<3>().cast<float>();
        end.rotation = turned(turned(start.rotation, (h - gamma) * velocity.tail<3>().cast<float>()),
                              gamma * now.tail<3>().cast<float>());
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

}  // namespace weft
