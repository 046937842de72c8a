#pragma once
// Particles against colliders, moving or not, with Coulomb friction.

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "engine/bounds.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/threads/parallel_blocks.h"
#include "engine/vector.h"
#include "weft/collider.h"
#include "weft/error.h"

namespace weft {

class HeldShape;
class WholeTriangles;

/// One collider over one substep: where it was at its start and is at its end.
struct ColliderMotion {
    Collider start, end;  // the same alternative in both
    /// No point of its axis, and no surface that grows or is a plane, moves what it meets faster than this,
    /// however far the collider jumps [m/s].
    float fastest = std::numeric_limits<float>::max();
    const HeldShape* held = nullptr;  ///< of a PlacedShape
    float rate = 0;          ///< steps of the host a second, where what is held deforms in this one [1/s]
    std::int32_t body = -1;  ///< the number of the body that carries it; -1: none
    /// Of the body at the end [m], [m/s], [rad/s]: a ball's ends have no spin.
    Vector3 centre = Vector3::Zero(), velocity = Vector3::Zero(), spin = Vector3::Zero();
    /// Around all that it fills on its way, with its own thickness: what is far off is told by this alone.
    Bounds filled = everywhere;
};

/// Error: a value outside its range in collider.h.
[[nodiscard]] Result<void> validate(const Collider& collider);

/// The collider a fraction t of the way from `from` to `to`: points, radius, offset and numbers are blended,
/// normals blended and normalised; layers are `to`'s. Precondition: the same alternative in both.
[[nodiscard]] Collider blend(const Collider& from, const Collider& to, float t);

/// What a cloth brings to its contacts with colliders. How the two go together, collider.h says.
struct ClothSide {
    /// Each particle keeps such a distance [m], and has such a friction.
    std::span<const float> thickness, friction;
    float most_thickness = 0;  ///< no particle's is more [m]
    float restitution = 0;
    std::uint32_t mask = ~0u;  ///< of the layers that it meets
    float least_bounce = 0;    ///< what comes slower does not bounce [m/s]

    [[nodiscard]] bool meets(const Collider& collider) const { return (collider.layers & mask) != 0; }
    /// The same of some of its particles.
    [[nodiscard]] ClothSide part(std::uint32_t begin, std::uint32_t size) const {
        ClothSide part = *this;
        part.thickness = thickness.subspan(begin, size);
        part.friction = friction.subspan(begin, size);
        return part;
    }
};

/// The distance at which the collider can first touch a particle of the cloth [m].
inline float thickness_of(const ColliderMotion& motion, const ClothSide& cloth) {
    return cloth.most_thickness + motion.end.thickness;
}
inline float restitution_of(const ColliderMotion& motion, const ClothSide& cloth) {
    return std::max(cloth.restitution, motion.end.restitution);
}

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

/// Moves every free particle (inverse mass > 0) that is nearer than the thickness to a collider's surface, or
/// inside it, out to the thickness; takes from its velocity relative to the surface what approaches it, gives
/// it what bounces, and takes by Coulomb's law what slides along it. Friction moves the position too, so that
/// cloth at rest on a slope does not creep. Colliders act in order. h: length of the substep [s]. Returns the
/// number of particles that met a collider. Preconditions: block_partials.size() >=
/// block_count(positions.size()); `cloth` has as many particles.
std::uint32_t collide(Parallel& parallel, std::span<const ColliderMotion> colliders, const ClothSide& cloth,
                      float h, const CollidingParticles& particles, std::span<std::uint32_t> block_partials);

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
