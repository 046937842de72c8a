#pragma once
// Particles against colliders, moving or not, with Coulomb friction.

#include <array>
#include <cstdint>
#include <span>

#include "collision/shapes/collider_motion.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/threads/parallel_blocks.h"
#include "engine/vector.h"

namespace weft {

class WholeTriangles;

/// A cloth's particles over a substep.
struct CollidingParticles {
    std::span<Vec4> positions, velocities;  ///< at its end; positions.w inverse mass
    /// Where they were when it began; may be empty. Those that have moved far against a collider meet it
    /// where they first came near it, and go to the side of it on which they did.
    std::span<const Vec4> starts = {};
    /// Not 0 where forces of contact have acted already, and friction with them. May be empty.
    std::span<const Vec4> held = {};
    /// Then, where there are `starts`, these are kept out of what is thin or sharp; null: none are.
    WholeTriangles* whole = nullptr;
};

/// collide() of thin/collide.h, of particles alone.
std::uint32_t collide_particles(Parallel& parallel, std::span<const ColliderMotion> colliders,
                                const ClothSide& cloth, float h, const CollidingParticles& particles,
                                std::span<std::uint32_t> block_partials);

/// Vectors of a block's particles, component by component.
struct BlockLanes {
    alignas(64) std::array<float, block_size> x, y, z, w;
};

/// Where particles of a block are going to be, and what they meet there or on the way. Arrays are written to
/// the end of a group of 16.
struct NearSurfaces {
    BlockLanes points;    ///< at the substep's end [m]; w inverse mass
    BlockLanes surfaces;  ///< outward normal; w distance less the thickness [m], `reach` where none is near
    /// The surface's velocity [m/s]; w friction of cloth and collider together, held_fast where the particle
    /// is inside another collider, too, which it faces: no place is free for it.
    BlockLanes motions;
    /// Likewise of surfaces inside of which the substep began, apart from all others until all are known.
    BlockLanes inside, inside_motions;
    bool has_inside = false;  ///< any; else these are not written
};

/// Friction of what goes with the surface whatever pulls.
inline constexpr float held_fast = 1e30f;

/// For each of at most block_size particles, which `cloth` is of, the surface, at the substep's end, that is
/// nearest of those nearer than the thickness and the reach. Particles go to positions + gamma velocities;
/// arrays go on to the end of a group of 16, also those of `cloth`. starts, if not empty: as in collide(); a
/// surface that a particle has passed counts as one in which it is. Returns whether any is near; else only
/// the points are written.
///
/// bodies, if not empty, gets of each particle ColliderMotion::body of the nearest, -1 where none is near.
bool find_near_surfaces(std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h,
                        float reach, std::span<const Vec4> starts, std::span<const Vec4> positions,
                        float gamma, std::span<const Vec4> velocities, NearSurfaces& near,
                        std::span<std::int32_t> bodies = {});
/// The same; w of `motions` is restitution.
bool find_bouncing_surfaces(std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h,
                            float reach, std::span<const Vec4> positions, float gamma,
                            std::span<const Vec4> velocities, NearSurfaces& near);

/// In how many equal parts a substep is best cut, at most `most`, since a collider that moves farther than it
/// is thin meets particles: in a part, none of those about goes farther against it than its radius and the
/// thickness. An equation that is linear about where a part begins bends no flat cloth round a thin bar that
/// ends far off. 1 where none meets any. Precondition: as of collide().
[[nodiscard]] std::uint32_t parts_to_meet(Parallel& parallel, std::span<const ColliderMotion> colliders,
                                          const ClothSide& cloth, float h, std::uint32_t most,
                                          std::span<const Vec4> positions, std::span<const Vec4> velocities,
                                          std::span<std::uint32_t> block_partials);

}  // namespace weft
