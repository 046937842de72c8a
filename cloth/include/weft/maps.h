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
};

}  // namespace weft
