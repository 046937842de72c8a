#pragma once
// Shapes that cloth collides with. Beyond the stated ranges single precision would make contacts that are not
// finite.
//
// Where two surfaces meet, whether colliders, bodies or cloth, their properties combine by one rule.
// Friction: colliders and layers of cloth have Coulomb coefficients, of which the geometric mean counts;
// towards a collider a cloth has the collider's coefficient, times its own ClothSettings::friction, a factor
// that is 1 by default. Thickness: each surface keeps its own, so that both add up; layers of cloth keep half
// of SelfCollision::distance each. Restitution: the greater counts.

#include <cstdint>
#include <variant>

#include "weft/shapes.h"
#include "weft/types.h"

namespace weft {

struct Sphere {
    Vec3 center{};        ///< [m], each coordinate from -1e5 to 1e5
    float radius = 0.1f;  ///< [m], from 1e-6 to 1e5
};

/// All points within `radius` of the segment a b.
struct Capsule {
    Vec3 a{}, b{};        ///< [m], each coordinate from -1e5 to 1e5; a == b is a sphere
    float radius = 0.1f;  ///< [m], from 1e-6 to 1e5
};

/// The union of balls about the points of the segment a b, their radii linear from radius_a to radius_b: a
/// limb. If one end's ball contains the other's, the shape is that ball.
struct TaperedCapsule {
    Vec3 a{}, b{};           ///< [m], each coordinate from -1e5 to 1e5
    float radius_a = 0.1f;   ///< [m], from 1e-6 to 1e5
    float radius_b = 0.05f;  ///< [m], from 1e-6 to 1e5
};

/// A rotation as a quaternion: x, y and z are the axis times sin(angle / 2), w is cos(angle / 2). It may have
/// any length from 1e-6 to 1e6, and counts as the unit quaternion of its direction.
struct Rotation {
    float x = 0, y = 0, z = 0, w = 1;
};

struct Box {
    Vec3 center{};                        ///< [m], each coordinate from -1e5 to 1e5
    Rotation rotation{};                  ///< orientation of its axes in the World
    Vec3 half_extents{0.1f, 0.1f, 0.1f};  ///< along its axes [m], each from 1e-6 to 1e5
};

/// The half space normal . p <= offset is solid.
struct Plane {
    Vec3 normal{0, 1, 0};  ///< of any length from 1e-12 to 1e12
    float offset = 0;      ///< [m], along the unit normal, from -1e5 to 1e5
};

/// An instance of a shape that the World holds.
struct PlacedShape {
    ShapeId shape{};
    Vec3 position{};      ///< place of the shape's origin [m], each coordinate from -1e5 to 1e5
    Rotation rotation{};  ///< orientation of its axes in the World
};

/// A shape that cloth collides with. Moving or placing the collider can change all of it: a move interpolates
/// numbers over the step, while layers and triggers have their new values from its start.
struct Collider {
    std::variant<Sphere, Capsule, Plane, TaperedCapsule, Box, PlacedShape> shape{};
    float friction = 0.4f;  ///< Coulomb coefficient, from 0 to 1e6
    float thickness = 0;    ///< distance kept from it [m], from 0 to 10
    /// Coefficient of restitution, from 0 to 1: a particle's normal velocity after a hit over that before.
    /// Impacts slower than twice the velocity that gravity adds in a substep do not bounce, so that cloth
    /// comes to rest.
    float restitution = 0;
    /// A cloth meets the collider if its ClothSettings::collider_mask has a bit of these, and a vertex if its
    /// Map::collider_mask has one, too. A collider that a cloth does not meet costs it no time, and is not in
    /// its contacts.
    std::uint32_t layers = 1;
    /// A trigger exerts no force and changes no byte of the motion. World::contacts() has one contact, the
    /// deepest and without an impulse, for each cloth with a particle nearer than the thickness at a step's
    /// end. Without contact reports a trigger costs no time.
    bool is_trigger = false;
};

/// How colliders act on cloth. Particles are tested along their paths; whole triangles, only against
/// colliders so thin or sharp that they slip between particles. Thin are (radius and thickness together, in
/// the cloth's mean edges) capsules below .55 and balls below .8, both below 1.1 while the host moves them,
/// and below 2 at fast impacts. Sharp are edges and corners of boxes, hulls and closed convex meshes (of at
/// most 32 corners) while the host moves these, and where cloth comes at more than 1 m/s. Sides of triangles
/// are kept half the thickness outside. Cloth on thin colliders is held and does not come to rest; triangles
/// that lie on a box which stands still cut its corners.
///
/// Penetration that a step finds at its start, because a collider was placed over cloth or cloth was moved
/// into it, becomes no velocity: it shrinks at 0.1 m/s, beyond 5 cm by e^-2 a second. Cloth in the middle of
/// a ball, box, hull or mesh, where the nearest ways out would part it, moves along with the collider and
/// leaves it as a whole, at 0.1 m/s. Penetration that the step itself causes is removed at once; that by a
/// body with mass or a deforming mesh always counts so.
/// Where colliders overlap and no place is free, cloth keeps to the surface of the collider added last (the
/// greatest ColliderId::index), moves along with it, and does not slide; it leaves the others as soon as one
/// of them makes room.
enum class ColliderResponse : std::uint8_t {
    /// Cloth is kept `thickness` outside, with Coulomb's friction, in the equation where the method is
    /// implicit.
    contact,
    /// Filters velocities only, after the solve and before positions follow: a particle inside a shape loses
    /// the velocity that leads farther in (Levin, CSC2549, 2020). Cheapest, and meant for comparison: cloth
    /// sinks in by up to a step's displacement and is never pushed out, it slides without friction, its own
    /// thickness is ignored, nothing bounces, and no contacts are reported.
    velocity_filter,
};

/// A generation-checked id; all-zero is null.
struct ColliderId {
    std::uint32_t index = 0, generation = 0;
    friend bool operator==(ColliderId, ColliderId) = default;
};

}  // namespace weft
