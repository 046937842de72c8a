#pragma once
// Shapes that cloth collides with. Beyond the stated ranges single precision would make contacts that are not
// finite.

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

/// All balls about the points of the segment a b, their radii going evenly from radius_a to radius_b: a limb.
/// Where one end's ball holds the other's, it is that ball.
struct TaperedCapsule {
    Vec3 a{}, b{};           ///< [m], each coordinate from -1e5 to 1e5
    float radius_a = 0.1f;   ///< [m], from 1e-6 to 1e5
    float radius_b = 0.05f;  ///< [m], likewise
};

/// A rotation as a quaternion: x, y and z are the axis times sin(angle / 2), w is cos(angle / 2).
struct Rotation {
    float x = 0, y = 0, z = 0, w = 1;  ///< together of a length from 0.999 to 1.001
};

struct Box {
    Vec3 center{};                        ///< [m], each coordinate from -1e5 to 1e5
    Rotation rotation{};                  ///< of its axes from the World's
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
    Vec3 position{};      ///< of its origin [m], each coordinate from -1e5 to 1e5
    Rotation rotation{};  ///< of its axes from the World's
};

/// What of it two surfaces have together, and what a cloth's own has to do with it, each field says. All of
/// it can be changed by moving or placing the collider: by moving, numbers go along with it over the step,
/// and layers and triggers are what they are to be from its start.
struct Collider {
    std::variant<Sphere, Capsule, Plane, TaperedCapsule, Box, PlacedShape> shape{};
    float friction = 0.4f;  ///< Coulomb coefficient, from 0 to 1e6; multiplied by the cloth's own
    float thickness = 0;    ///< distance kept from it, added to the cloth's own [m], from 0 to 10
    /// Of the normal velocity with which a particle hits it, the part with which it leaves, from 0 to 1; the
    /// greater of this and the cloth's own. What comes slower than twice what gravity adds in a substep does
    /// not bounce, so that cloth comes to rest.
    float restitution = 0;
    /// A cloth meets it if its ClothSettings::collider_mask has a bit of these. One that it does not meet
    /// takes it no time, and is not in its contacts.
    std::uint32_t layers = 1;
    /// No force, and not a byte of the motion; World::contacts() has one contact, without an impulse, for
    /// each cloth of which a particle is nearer than the thickness when a step ends: the deepest. Where none
    /// are reported it takes no time.
    bool is_trigger = false;
};

/// What colliders do to cloth. Particles are met on their way, triangles by what is so thin that it slips
/// between them. Such are, with the thickness, in the cloth's mean edges: capsules thinner than .55 and
/// balls than .8, both than 1.1 while the host moves them and than 2 where they meet it fast; the edges and
/// corners of boxes, hulls and closed convex meshes (of at most 32 corners) while the host moves these. Sides
/// are kept half the thickness outside. Cloth on such capsules and balls is held and does not come to rest;
/// over edges of a box that stands still triangles cut its corners.
///
/// How deep a step finds a particle in a collider when it begins, where it was placed over cloth or cloth was
/// moved into it, becomes no velocity: it comes out at 0.1 m/s, from more than 5 cm by e^-2 a second. What a
/// step brings is put outside at once, but for what a body with mass or a deforming mesh does to it, which is
/// always that. Where colliders overlap, so that no place is free, cloth keeps to the surface of the one that
/// was added last (of those with the greater ColliderId::index), goes along with it, and does not slide; it
/// comes out of the others as soon as one of them makes room.
enum class ColliderResponse : std::uint8_t {
    /// Cloth is kept `thickness` outside, with Coulomb's friction, in the equation where the method is
    /// implicit.
    contact,
    /// Velocities alone are filtered, as solved and before positions follow them: of a particle inside a
    /// shape, what goes farther in is taken (Levin, CSC2549, 2020). Cheapest, and to compare with: cloth
    /// sinks in by up to a step's way and is never pushed out, it slides without friction, its own thickness
    /// has no part in it, nothing bounces, and no contacts are reported.
    velocity_filter,
};

/// Generation-checked; all-zero is null.
struct ColliderId {
    std::uint32_t index = 0, generation = 0;
    friend bool operator==(ColliderId, ColliderId) = default;
};

}  // namespace weft
