#pragma once
// Settings of cloth that meets itself and other cloth.

#include <cstdint>

namespace weft {

/// How cloth is kept from passing through cloth, and what each method guarantees.
enum class SelfCollisionMethod : std::uint8_t {
    off,  ///< Cloth passes through cloth, at no cost.
    /// What to choose. Contact between triangles of one cloth, and of all cloths with this method, is part of
    /// the step's equation, and a motion that would still pass through is truncated. Cloth that has not
    /// crossed does not cross; cloth that starts crossed separates towards the side on which most of it lies.
    /// Cloths that start at exactly one place separate in the order in which they were added, each on the
    /// front of those before it; layers of one mesh that face opposite ways separate on their fronts.
    /// Multilevel, the default, solves so; other methods solve without contact, then truncate and push apart,
    /// which crosses nothing either, but stretches or locks cloth in piles. Costs some 0.2 ms a step and
    /// thousand particles where cloth is calm, 3 where it lies folded. Touching cloths of which contact
    /// truncated more than a few particles take their next ten steps in halves. Layers that slide over each
    /// other by more than some three quarters of an edge in a step are braked.
    contact,
    /// Collisions within a step, of one cloth and of all cloths with this method, are resolved together after
    /// the solve, zone by zone; linear momentum is kept to rounding (Huh, Metaxas, Badler, "Collision
    /// resolutions in cloth simulation", 2001). Against cloth by contact, both motions are truncated as by
    /// contact. Works with every solver. Bounded: two searches a substep, three rounds after each, 16 pairs
    /// of features a particle (4096 at least). Pairs that remain, or for which there is no room, pass through
    /// and stay so, see StepReport::unresolved_pairs. No friction between layers, no contact reports.
    ///
    /// Guarantees momentum and a restitution. Layers that touch and separate, or lie in a stack, do not
    /// cross; cloth that is pulled tight, crumpled or knotted crosses more than by avoidance, and is
    /// stretched. Costs half to five times what contact does. Prefer contact wherever layers press.
    impact_zones,
    /// Particles of one cloth are kept apart after the step is solved (Kang, "Efficient Methods for Cloth
    /// Animation and Collision Handling", section IV); every pair closer than the distance is found. For
    /// crowds: cheap, but it fails where cloth is pressed, pulled or fast. Layers then pass through each
    /// other, and stay so. Folds of cloth at rest tremble, some of their particles at half a metre a second,
    /// because springs pull back particles that were pushed.
    avoidance,
    /// Avoidance by Kang's two grids, the second shifted by half a cell; each particle is tested against its
    /// own bucket only. Misses pairs that are split by one axis in the first grid and by another in the
    /// second (four of five on crumpled cloth).
    avoidance_by_shifted_grids,
    /// Avoidance by NvCloth's search: particles are sorted along the cloth's longest side, in at most 253 x
    /// 253 columns across it. Finds every pair. Columns grow with the cloth, and so does the time: once one
    /// particle has flown off, all are tested with all. Takes 36 bytes a particle more.
    avoidance_by_sorted_sweep,
};

/// Whether cloths with this method meet each other. By the other methods each meets itself alone, or nothing.
constexpr bool meets_cloth(SelfCollisionMethod method) {
    return method == SelfCollisionMethod::contact || method == SelfCollisionMethod::impact_zones;
}

/// Contact of cloth with itself and, by contact and by impact zones, with other cloth. Pairs that the mesh
/// itself keeps close are excluded: by avoidance, particles that a spring joins or whose shortest path along
/// springs at rest is below 1.25 times the distance; by contact, the same for features' corners along edges.
/// The initial pose excludes none: layers that start closer than the distance are pushed apart.
struct SelfCollision {
    /// Switching it on, or changing the distance, takes a search from each particle once.
    SelfCollisionMethod method = SelfCollisionMethod::off;
    /// Distance that is kept between triangles, of two cloths the mean of theirs, or by avoidance between
    /// particles [m], 1e-6 to 10. 0: 0.3 of the mean rest edge, by avoidance 0.75 of it. At most 256
    /// particles, on average, may be within it along the cloth: some seven edges.
    float distance = 0;
    /// Coulomb coefficient between layers, 0 to 1000; of two cloths the geometric mean of theirs.
    float friction = 0.3f;
    /// Coefficient of restitution of impact zones, 0 to 1: relative velocity of layers after a collision over
    /// that before; of two cloths the greater. Must be 0 with other methods.
    float restitution = 0;
    /// By contact and impact zones: two cloths meet if each one's mask has a bit of the other's layers. No
    /// mask keeps a cloth from meeting itself.
    std::uint32_t layers = 1, mask = ~0u;
};

}  // namespace weft
