#pragma once
// Rigid bodies that cloth moves. Colliders and vertices are attached to a body, which receives the reaction
// to what they give cloth. Cloth that lies on another collider stops a body.
//
// A body's colliders also meet the World's colliders that no body carries, where their layers share a bit:
// they rest there, slide and bounce by the rule of collider.h, up to a step early. A hull or mesh of a body
// has corners only, of more than 32 the farthest in 26 directions. Collisions of bodies with one another are
// the host's.
//
// Cloth that has attached vertices, or is within 5 cm of a body's collider, never sleeps, however still both
// are. Cloth in a frame (World::set_frame) meets bodies where they are in the World. A body's colliders have
// no restitution where contact is in the equation. World::shift_origin moves bodies too.
//
// A free body that lies on cloth which hangs from attached vertices alone drifts to the side, and falls off.
// Pin cloth that has to hold one.

#include <cstdint>

#include "weft/collider.h"
#include "weft/types.h"

namespace weft {

/// Generation-checked; all-zero is null.
struct BodyId {
    std::uint32_t index = 0, generation = 0;
    friend bool operator==(BodyId, BodyId) = default;
};

/// A body's frame has its origin at the centre of mass, and its axes along those of its inertia.
struct BodySettings {
    float mass = 1;  ///< [kg], 1e-6 to 1e9; 0: nothing changes the body's velocity
    /// Moments about its axes [kg m^2], each 1e-12 to 1e12; 0: nothing turns the body about this axis. A
    /// solid ball has 0.4 m r^2; a box with edges a, b, c has m / 12 (b^2 + c^2) about the first axis.
    Vec3 inertia{0.01f, 0.01f, 0.01f};
    float gravity_scale = 1;    ///< factor of WorldSettings::gravity, -1000 to 1000; 0 where the host adds it
    float damping = 0;          ///< rate at which velocity decays [1/s], 0 to 1e6
    float angular_damping = 0;  ///< rate at which angular velocity decays [1/s], 0 to 1e6
};

/// Pose and velocities of a body.
struct BodyState {
    Vec3 position{};          ///< centre of mass [m], each coordinate from -1e5 to 1e5
    Rotation rotation{};      ///< rotation of the body's axes from the World's
    Vec3 velocity{};          ///< velocity of the centre of mass [m/s], each component up to 1e4
    Vec3 angular_velocity{};  ///< about the World's axes [rad/s], each component up to 1e4
};

/// Impulse that all cloth gave a body in a step, by contact and by attached vertices, friction included.
struct BodyImpulse {
    BodyId body{};
    Vec3 linear{};   ///< [N s]; over the step's length it is the mean force [N]
    Vec3 angular{};  ///< angular impulse about the body's centre of mass [N m s]
};

}  // namespace weft
