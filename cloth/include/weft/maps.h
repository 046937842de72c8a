#pragma once
// Quantities that vary from vertex to vertex of a cloth.

#include <cstdint>

namespace weft {

/// A number for each vertex of the mesh, see World::set_map. A particle has the mean of its welded vertices,
/// unless another rule is stated.
enum class Map : std::uint8_t {
    /// Factor of Fabric::areal_density, from 0.01 to 100; 1 without the map. Not with
    /// FiniteElements::consistent_mass.
    mass,
    /// Pinned or free, from 0 to 1: from 0.5 on the vertex is pinned, below it is released. Of welded
    /// vertices the greatest counts. The map acts at the call, and is not stored.
    pin,
    /// Greatest distance from the vertex's place on the skin [m], from 0. Infinity, as without the map: no
    /// leash. Of welded vertices the least counts.
    leash,
    /// Distance behind the vertex's place on the skin, against the normal, at which the forbidden region
    /// begins [m], from -10. Infinity, as without the map: no backstop. Less than 0: in front of the skin,
    /// and no farther than the leash is long. Of welded vertices the least counts.
    backstop,
    /// Radius of the backstop's sphere [m], at least 1e-3. Infinity, as without the map, makes the backstop a
    /// plane. Of welded vertices the greatest counts.
    backstop_radius,
    friction,  ///< factor of ClothSettings::friction, from 0 to 1000; 1 without the map
    /// Factor of ClothSettings::thickness, from 0 to 1; 1 without the map. Of welded ones the greatest is
    /// used.
    thickness,
    /// Factor of Fabric::warp, weft and shear, from 0.001 to 1000; 1 without the map. A triangle, or a
    /// sheet's cell, has the mean of its corners. Not with FiniteElements::consistent_mass.
    stiffness,
    /// Bits of Collider::layers that the vertex meets, as a whole number from 0 to most_collider_mask, of
    /// those in ClothSettings::collider_mask: so a sleeve does not meet the torso. Without the map it meets
    /// all of these. A side meets a thin collider if both its ends do. Of welded vertices all bits count.
    collider_mask,
};

/// Greatest value of Map::collider_mask: the lowest 24 layers, the most that a float holds exactly. Vertices
/// of a cloth with the map do not meet colliders that are in higher layers alone.
inline constexpr float most_collider_mask = 16777215;

}  // namespace weft
