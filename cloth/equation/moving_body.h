#pragma once
// A rigid body over a part of a step.

#include <cstdint>

#include "collision/colliders/carried.h"
#include "collision/shapes/collider_motion.h"
#include "engine/simd/symmetric3.h"
#include "engine/vector.h"
#include "weft/body.h"

namespace weft {

/// Linear and angular velocity of a body; or an impulse and its moment about the centre of mass.
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// The force and torque about the centre of mass, or impulses of both, of `impulse` at `arm` from there.
[[nodiscard]] Vector6 wrench(const Eigen::Vector3d& arm, const Eigen::Vector3d& impulse);

/// A^T g A, where A gives the velocity of a body's point at `arm`: the mass or spring g of that point as one
/// of the whole body.
[[nodiscard]] Matrix6 at_arm(const Eigen::Vector3d& arm, const Eigen::Matrix3d& g);

/// A body over a part of a step. Only its end changes while cloth is solved with it.
struct MovingBody {
    double inverse_mass = 0;                                    ///< [1/kg]
    Eigen::Vector3d inverse_inertia = Eigen::Vector3d::Zero();  ///< [1/(kg m^2)]
    float h = 0, gamma = 0;              ///< the part's length; its equation's gamma [s]
    double fastest = 1e9;                ///< bound on the speed of the body and its attached cloth [m/s]
    double reach = 0;                    ///< from the centre of mass to the farthest attached particle [m]
    BodyPose start;                      ///< pose when the part begins
    Vector6 velocity = Vector6::Zero();  ///< velocity when it begins
    Vector6 drift = Vector6::Zero();     ///< velocity at the end without cloth
    Eigen::Vector3d turn = Eigen::Vector3d::Zero();      ///< rotation vector of the part without cloth
    Eigen::Vector3d momentum = Eigen::Vector3d::Zero();  ///< angular momentum then, if uneven
    Vector6 free = Vector6::Zero();      ///< drift, and what of cloth's impulse is known beforehand
    Matrix6 root = Matrix6::Zero();      ///< its inverse mass is root root^T
    Vector6 expected = Vector6::Zero();  ///< impulse that cloth is expected to give [N s, N m s]
    Vector6 now = Vector6::Zero();       ///< velocity at the end, as far as it is known
    BodyPose end;                        ///< pose at the end, as far as it is known
    bool is_stopped = false;             ///< by the World's colliders: it ends at start + h now

    /// Whether an impulse changes the body's motion.
    [[nodiscard]] bool gives_way() const;
    /// Sets `root` for axes turned by `rotation`.
    void set_root(const Eigen::Quaternionf& rotation);
    /// Sets `now` and `end` from the expected impulse.
    void expect();
    /// Adds an impulse of the World's colliders to what the body does without cloth.
    void stop(const Vector6& impulse);
    /// Whether the inertia tensor turns with the body.
    [[nodiscard]] bool is_uneven() const;
    /// The inverse inertia tensor at a rotation: maps angular momentum to angular velocity.
    [[nodiscard]] Eigen::Matrix3d inverse_inertia_at(const Eigen::Quaternionf& rotation) const;
    /// A velocity, or a displacement in `time` seconds, scaled down to the bound `fastest`.
    [[nodiscard]] Vector6 limited(const Vector6& way, double time = 1) const;
    /// Sets the end as collided particles move: x + (h - gamma) v + gamma v', see History; and turned by
    /// `turn`, and by what cloth adds to it.
    void find_end();
    /// Finds `turn`, and the angular velocity after it, of a body that nothing touches. An uneven one keeps
    /// its momentum to rounding, and its energy, at any speed.
    void turn_freely();
    /// Fixes the inertia at the expected end. An inertia that turned with the solution would amplify small
    /// impulses about other axes, and attached cloth would be flung off.
    void turn_inertia();
    /// The inertia tensor whose inverse is in `root`; no axis may be fixed.
    [[nodiscard]] Eigen::Matrix3d inertia() const;
    /// The start pose from which the body reaches its end at the constant velocity `now`: its surfaces move
    /// at that velocity.
    [[nodiscard]] BodyPose swept_from() const;
    /// Sets the motion of a collider that is attached to the body, given in the body's frame.
    void move(const Collider& own, ColliderMotion& motion) const;
    [[nodiscard]] Vector3 velocity_at(const Vector3& point) const;
};

/// A particle that is attached to a body.
struct Attachment {
    std::uint32_t particle;
    std::uint32_t body;  ///< its number among the World's, in the present step
    Vector3 own;         ///< its place in the body's frame [m]
    BodyId id;
};

/// A particle that presses on a body or is attached to it, as last linearised.
struct BodyPush {
    std::uint32_t particle, body;
    Vector3 arm;       ///< from the centre of mass to the particle, or to its place of attachment [m]
    Vector3 velocity;  ///< of the particle, at the linearisation [m/s]
};

/// A body's contact with a particle that does not give way, as last linearised: at the velocity u of the
/// body's point there the particle would get impulse + response (u - velocity), and the body gets the
/// opposite.
struct BodyStop {
    std::uint32_t body;
    Vector3 arm;          ///< from the centre of mass [m]
    Vector3 velocity;     ///< of the body's point, at the linearisation [m/s]
    Vector3 impulse;      ///< [N s]
    Symmetric3 response;  ///< [kg]
};

}  // namespace weft
