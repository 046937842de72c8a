#pragma once
// Particles against colliders, moving or not, with Coulomb friction.

#include <array>
#include <cstdint>
#include <limits>
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
    /// Positions when the substep began; may be empty. A particle that has moved far relative to a collider
    /// meets it where it first came near, and is pushed out to that side.
    std::span<const Vec4> starts = {};
    /// Not 0 where contact forces have acted already: no friction is added there. May be empty.
    std::span<const Vec4> held = {};
    /// Triangles that are then kept out of thin and sharp colliders, if there are `starts`; null: none.
    WholeTriangles* whole = nullptr;
    float deep = std::numeric_limits<float>::infinity();  ///< see MetParticles [m]
};

struct MetParticles {
    std::uint32_t count;  ///< of particles that met a collider
    bool left_deep;       ///< whether the substep found any deeper inside one than CollidingParticles::deep
};

/// collide() of thin/collide.h, for particles alone.
MetParticles collide_particles(Parallel& parallel, std::span<const ColliderMotion> colliders,
                               const ClothSide& cloth, float h, const CollidingParticles& particles,
                               std::span<std::uint32_t> block_partials);

/// Vectors of a block's particles, component by component.
struct BlockLanes {
    alignas(64) std::array<float, block_size> x, y, z, w;
};

/// Predicted positions of a block's particles, and the surfaces that they meet there or on the way. Arrays
/// are written to the end of a group of 16.
struct NearSurfaces {
    BlockLanes points;    ///< at the substep's end [m]; w inverse mass
    BlockLanes surfaces;  ///< outward normal; w distance less the thickness [m], `reach` where none is near
    /// The surface's velocity [m/s]; w friction of cloth and collider together. w is held_fast if the
    /// particle is inside another collider that faces this one: no place is free for it.
    BlockLanes motions;
    /// The same for surfaces around a particle at the substep's start, apart until all are known.
    BlockLanes inside, inside_motions;
    bool has_inside = false;  ///< whether any; else these are not written
};

/// Friction of a particle that sticks to the surface under any load.
inline constexpr float held_fast = 1e30f;

/// Finds the nearest surface, at the substep's end and within thickness plus reach, of each of at most
/// block_size particles with the properties in `cloth`. They move to positions + gamma velocities. Arrays,
/// also those of `cloth`, extend to the end of a group of 16. starts, if not empty: as in collide(); a
/// particle that has passed a surface counts as inside. Returns whether any is near; else only the points are
/// written.
///
/// bodies, if not empty: ColliderMotion::body of each particle's nearest collider, -1 if none is near.
bool find_near_surfaces(std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h,
                        float reach, std::span<const Vec4> starts, std::span<const Vec4> positions,
                        float gamma, std::span<const Vec4> velocities, NearSurfaces& near,
                        std::span<std::int32_t> bodies = {});
/// The same; w of `motions` is restitution.
bool find_bouncing_surfaces(std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h,
                            float reach, std::span<const Vec4> positions, float gamma,
                            std::span<const Vec4> velocities, NearSurfaces& near);

/// Number of equal parts, at most `most`, for a substep in which a collider that moves farther than it is
/// thin, or that cloth goes past by several times its width, meets particles: within a part no nearby
/// particle moves farther relative to it than its radius and the thickness. An equation linearised at a
/// part's start cannot bend flat cloth round a thin bar that ends far off. 1 if no such collider meets any.
/// Precondition: as of collide().
[[nodiscard]] std::uint32_t parts_to_meet(Parallel& parallel, std::span<const ColliderMotion> colliders,
                                          const ClothSide& cloth, float h, std::uint32_t most,
                                          std::span<const Vec4> positions, std::span<const Vec4> velocities,
                                          std::span<std::uint32_t> block_partials);

}  // namespace weft
