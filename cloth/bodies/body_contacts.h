#pragma once
// Contact of a rigid body with the World's colliders that no body carries.

#include <array>
#include <limits>
#include <span>

#include "cloth/equation/moving_body.h"

namespace weft {

/// Contacts of one body over a part of a step: places where the corners and edges of its colliders are near
/// another collider, and the reverse. Capsules and boxes have edges; a mesh has them where one of these is
/// near.
class BodyContacts {
  public:
    explicit BodyContacts(const MovingBody& body) : body_(body) {}

    /// Adds the contacts that a collider of the body, given in the body's frame, has at this pose with
    /// `other`, where this one is when the part ends. Gaps above `reach` [m] are left out.
    void add(const Collider& own, const HeldShape* held, const BodyPose& pose, const ColliderMotion& other,
             float reach);

    void clear() {
        count_ = 0;
        nearest_ = std::numeric_limits<float>::infinity();
    }
    /// The least gap at the poses that were looked at [m].
    [[nodiscard]] float nearest() const { return nearest_; }
    /// The impulse that keeps the body out of the colliders: sequential impulses (Catto 2005, "Iterative
    /// dynamics with temporal coherence"), with Coulomb friction.
    [[nodiscard]] Vector6 impulse() const;

  private:
    struct Contact {
        Eigen::Vector3d arm;      ///< from the centre of mass [m]
        Eigen::Vector3d normal;   ///< outward from the collider
        Eigen::Vector3d surface;  ///< the collider's velocity there [m/s]
        double gap;               ///< when the part begins; below 0: penetration depth [m]
        double friction, restitution;
    };
    void add(const Contact& contact);

    const MovingBody& body_;
    static constexpr std::size_t most = 64;
    std::array<Contact, most> contacts_;  // the nearest ones, if there are more
    std::size_t count_ = 0;
    float nearest_ = std::numeric_limits<float>::infinity();
};

}  // namespace weft
