#pragma once
// Settings of self-collision avoidance.

#include <cstdint>

namespace weft {

/// How particles that are too close are looked for.
enum class SelfCollisionSearch : std::uint8_t {
    /// Every pair closer than the distance: equal to brute force.
    exact,
    /// Kang's two grids, the second shifted by half a cell, each particle against its own bucket only. Misses
    /// pairs that are split by one axis in the first grid and by another in the second (four of five on
    /// crumpled cloth).
    shifted_grids,
};

/// Keeps particles of one cloth at least `distance` apart (Kang, "Efficient Methods for Cloth Animation and
/// Collision Handling", section IV).
///
/// Left alone are particles that are near one another along the cloth: those that a spring joins, and those
/// whose shortest way along springs at rest is less than 1.25 times the distance. How the cloth lies at the
/// start has no part in it: layers that start closer than the distance are pushed apart.
struct SelfCollision {
    /// Off costs nothing. Switching it on, or changing the distance, takes a search from each particle once.
    bool enabled = false;
    /// Least distance between particles [m], 1e-6 to 10; 0: 0.75 of the mean rest edge. At most 256 others,
    /// on average, may be within it along the cloth: some seven edges.
    float distance = 0;
    float friction = 0.3f;  ///< Coulomb coefficient between layers, 0 to 1000
    SelfCollisionSearch search = SelfCollisionSearch::exact;
};

}  // namespace weft
