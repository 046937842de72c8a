#pragma once
// What can differ from vertex to vertex of one cloth.

#include <cstdint>

namespace weft {

/// A number for each vertex of the mesh, see World::set_map. Of vertices that were welded into one particle
/// it gets the mean, unless another rule is stated.
enum class Map : std::uint8_t {
    /// Times Fabric::areal_density, from 0.01 to 100; 1 without the map. Not with
    /// FiniteElements::consistent_mass.
    mass,
    /// From 0 to 1. From 0.5 on the vertex is pinned, below it is let go; of welded ones the greatest counts.
    /// It is done at once, and not kept.
    pin,
    /// Farthest from the vertex's place on the skin [m], from 0; infinity: no leash, as without the map. Of
    /// welded ones the least counts.
    leash,
    /// How far behind its place on the skin, against the normal, what the vertex never enters begins [m],
    /// from -10; infinity: no backstop, as without the map. Less than 0: in front of the skin, and no farther
    /// than the leash is long. Of welded ones the least counts.
    backstop,
    /// Of the ball that this is [m], from 1e-3; infinity, as without the map: all behind a plane. Of welded
    /// ones the greatest counts.
    backstop_radius,
    friction,   ///< times ClothSettings::friction, from 0 to 1000; 1 without the map
    thickness,  ///< times ClothSettings::thickness, from 0 to 1; 1 without the map. Of welded ones the
                ///< greatest counts.
    /// Times Fabric::warp, weft and shear, from 0.001 to 1000, of each triangle (a sheet's cell) the mean of
    /// its corners; 1 without the map. Not with FiniteElements::consistent_mass.
    stiffness,
};

}  // namespace weft
