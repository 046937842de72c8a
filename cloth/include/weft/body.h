#pragma once
// Rigid bodies that cloth moves: colliders and vertices are attached to them, and what these give cloth the
// body gets back. They meet cloth only; what bodies do to one another, and to the World's other colliders, is
// the host's. Cloth that lies on such a collider stops them.
//
// Cloth that has attached vertices, or is within 5 cm of a collider that a body carries, never sleeps,
// however still both are. Cloth in a frame (World::set_frame) meets bodies where they are in the World.
// Contact in the equation has no restitution on what a body carries. World::shift_origin moves bodies too.
//
// A free body that lies on cloth which hangs from attached vertices alone works its way to the side, and off:
// pin cloth that is to hold one.

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
    float mass = 1;  ///< [kg], 1e-6 to 1e9; 0: nothing moves it, it goes on at the velocity that it has
    /// About its axes [kg m^2], each 1e-12 to 1e12; 0: nothing turns it about this axis. Of a solid ball
    /// 0.4 m r^2 each; of a box with edges of a, b, c: m / 12 (b^2 + c^2), and so on.
    Vec3 inertia{0.01f, 0.01f, 0.01f};
    float gravity_scale = 1;    ///< of WorldSettings::gravity, -1000 to 1000; 0 where the host adds it
    float damping = 0;          ///< rate at which velocity decays [1/s], 0 to 1e6
    float angular_damping = 0;  ///< likewise
};

/// Where a body is and how it moves.
struct BodyState {
    Vec3 position{};          ///< of its centre of mass [m], each coordinate from -1e5 to 1e5
    Rotation rotation{};      ///< of its axes from the World's
    Vec3 velocity{};          ///< of its centre of mass [m/s], each component up to 1e4
    Vec3 angular_velocity{};  ///< about the World's axes [rad/s], each component up to 1e4
};

/// What all cloth gave a body in a step, by contact and where vertices are attached to it, friction included.
struct BodyImpulse {
    BodyId body{};
    Vec3 linear{};   ///< [N s]; over the step's length it is the mean force [N]
    Vec3 angular{};  ///< of the same, about the body's centre of mass [N m s]
};

}  // namespace weft
