#pragma once
// Settings of cloth that meets itself and other cloth.

#include <cstdint>

namespace weft {

/// How avoidance looks for particles that are too close.
enum class SelfCollisionSearch : std::uint8_t {
    /// Every pair closer than the distance: equal to brute force.
    exact,
    /// Kang's two grids, the second shifted by half a cell, each particle against its own bucket only. Misses
    /// pairs that are split by one axis in the first grid and by another in the second (four of five on
    /// crumpled cloth).
    shifted_grids,
    /// NvCloth's: sorted along the cloth's longest side, in at most 253 x 253 columns across it. Every pair,
    /// as by exact. Columns grow with the cloth, and with it the time: where one particle has flown off, all
    /// are tested with all. Takes 36 bytes a particle more.
    sorted_sweep,
};

/// What is promised of cloth that meets cloth.
enum class SelfCollisionMethod : std::uint8_t {
    /// Particles of one cloth are kept apart after the step is solved (Kang, "Efficient Methods for Cloth
    /// Animation and Collision Handling", section IV). Cheap, and it fails where cloth is pressed, pulled or
    /// fast: then layers pass through each other, and stay so. Folds of cloth that lies tremble, some of
    /// their particles at half a metre a second, since springs pull back what was pushed.
    avoidance,
    /// The default. Triangles of one cloth, and of all cloths with this method, meet in the step's equation,
    /// and a motion that would still take one through another is cut short. What has not crossed does not
    /// cross; what the start has crossed comes apart, the way that most of it lies. Cloths that start at
    /// exactly one place part in the order in which they were added, each on the front of those before it;
    /// layers of one mesh that face opposite ways part on their fronts. By Multilevel, the default; other
    /// methods solve without it and are cut and pushed apart afterwards, which crosses nothing either, but
    /// stretches or locks cloth in piles. Costs some 0.2 ms a step and thousand particles where cloth is
    /// calm, 3 where it lies folded. Cloths that touch, and of which contact had to cut more than a few
    /// particles, take their next ten steps in halves. Layers that slide over each other by more than some
    /// three quarters of an edge in a step are braked.
    contact,
    /// What collides within a step is resolved together once the step is solved, zone by zone, and linear
    /// momentum kept to rounding (Huh, Metaxas, Badler, "Collision resolutions in cloth simulation", 2001):
    /// of one cloth, and of all cloths with this method. Where these meet cloth by contact, both are cut as
    /// by contact. By any method of solving. Bounded: two searches a substep, three rounds after each, 16
    /// pairs of features a particle (4096 at least). What is left by then, or has no room, passes through and
    /// stays so, see StepReport::unresolved_pairs. No friction between layers, no contact reports.
    ///
    /// Promises momentum and a restitution. Layers that meet and part, or lie in a stack, do not cross; where
    /// cloth is pulled tight, crumpled or knotted, more of it crosses than by avoidance, and is stretched.
    /// Costs half to five times what contact does. Take contact instead wherever layers press.
    impact_zones,
};

/// Cloth that meets itself and, by contact and by impact zones, other cloth. What a mesh holds together is
/// left alone: by avoidance, particles that a spring joins or whose shortest way along springs at rest is
/// less than 1.25 times the distance; by contact, the same of features' corners along edges. How the cloth
/// lies at the start has no part in it: layers that start closer than the distance are pushed apart.
struct SelfCollision {
    /// Off costs nothing. Switching it on, or changing the distance, takes a search from each particle once.
    bool enabled = false;
    SelfCollisionMethod method = SelfCollisionMethod::contact;
    /// How far apart cloth is kept [m], 1e-6 to 10: triangles, of two cloths the mean of theirs;
    /// by avoidance, particles. 0: 0.3 of the mean rest edge, by avoidance 0.75 of it. At most
    /// 256 particles, on average, may be within it along the cloth: some seven edges.
    float distance = 0;
    /// Coulomb coefficient between layers, 0 to 1000; of two cloths the geometric mean of theirs.
    float friction = 0.3f;
    SelfCollisionSearch search = SelfCollisionSearch::exact;  ///< of avoidance
    /// Of impact zones, and 0 without: relative velocity of layers after a collision over that before it, 0
    /// to 1; of two cloths the lesser.
    float restitution = 0;
    /// By contact and impact zones: two cloths meet if each one's mask has a bit of the other's layers. No
    /// mask keeps a cloth from meeting itself.
    std::uint32_t layers = 1, mask = ~0u;
};

}  // namespace weft
