#pragma once
// A rigid body over a part of a step.

#include <cstdint>

#include "collision/colliders/carried.h"
#include "collision/shapes/collider_motion.h"
#include "engine/simd/symmetric3.h"
#include "engine/vector.h"
#include "weft/body.h"

namespace weft {

/// A velocity of a body and its angular one; or an impulse and its moment about the centre of mass.
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// The force and torque about the centre of mass, or impulses of both, of `impulse` at `arm` from there.
[[nodiscard]] Vector6 wrench(const Eigen::Vector3d& arm, const Eigen::Vector3d& impulse);

/// A^T g A, where A gives the velocity of a body's point at `arm`: a mass or a spring there, as the body
/// meets it.
[[nodiscard]] Matrix6 at_arm(const Eigen::Vector3d& arm, const Eigen::Matrix3d& g);

/// A body over a part of a step. Only its end changes while cloth is solved with it.
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
    [[nodiscard]] bool gives_way() const;
    /// Sets `root` for axes turned by `rotation`.
    void set_root(const Eigen::Quaternionf& rotation);
    /// Sets `now` and the end to what the expected impulse gives.
    void expect();
    /// Whether its inertia turns with it.
    [[nodiscard]] bool is_uneven() const;
    /// Times an angular momentum: the angular velocity.
    [[nodiscard]] Eigen::Matrix3d inverse_inertia_at(const Eigen::Quaternionf& rotation) const;
    /// A velocity, or a way in `time` seconds, scaled down to what `fastest` allows.
    [[nodiscard]] Vector6 limited(const Vector6& way, double time = 1) const;
    /// Sets the end as collided particles move: x + (h - gamma) v + gamma v', see History. A body that
    /// nothing touches turns at the mean of both ends' angular velocities, so that it keeps its energy.
    void find_end();
    /// Turns an uneven body of this momentum that nothing touches: the implicit midpoint rule.
    void turn_freely();
    /// Takes the inertia at the expected end. An inertia that turned on with the solution would make much of
    /// a little that is given about another axis, and attached cloth would fly.
    void turn_inertia();
    /// The inertia tensor whose inverse is in `root`; no axis may be fixed.
    [[nodiscard]] Eigen::Matrix3d inertia() const;
    /// The pose from which the body would come to its end at its velocity there: surfaces move at that
    /// velocity.
    [[nodiscard]] BodyPose swept_from() const;
    /// Moves a collider that the body carries, given in the body's frame.
    void move(const Collider& own, ColliderMotion& motion) const;
    [[nodiscard]] Vector3 velocity_at(const Vector3& point) const;
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
    Vector3 arm;  ///< from the centre of mass: of the particle, or of the place that it is attached to [m]
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
