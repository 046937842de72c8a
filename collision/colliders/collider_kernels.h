#pragma once
// A block of particles against one collider, many particles at a time; compiled once for each kind of
// machine.

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "collision/colliders/collider_contacts.h"
#include "collision/shapes/moving_shapes.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

/// Penetration depth that a substep finds at its start, as after a collider was placed over a particle. The
/// equation ignores it, so that it becomes no velocity. collide() removes it at a limited speed, except where
/// another collider holds the particle.
struct FoundDepth {
    static constexpr float speed = 0.1f;  ///< [m/s]
    static constexpr float rate = 2;      ///< if that is faster, this part of the depth a second [1/s]

    /// Smaller depths count as caused by the substep [m].
    float least = std::numeric_limits<float>::infinity();
};

/// Bodies yield within a substep, and deforming meshes move by any distance: the substep causes their depth.
[[nodiscard]] inline bool finds_depth(const ColliderMotion& motion) {
    return motion.body < 0 && motion.rate == 0;
}

struct ContactSettings {
    float thickness;                          ///< collider's and cloth's greatest together [m]
    float friction;                           ///< the collider's coefficient
    float h;                                  ///< [s]
    float restitution = 0, least_bounce = 0;  ///< of both; slower impacts [m/s] do not bounce
    FoundDepth found{};
    /// Particles that move farther than `thin` relative to the shape can pass it: their paths are swept. 0:
    /// none of the block moves as far.
    Meeting meeting{};
};

/// Colliders that a block's particles are left inside of: of several, the one with the greatest depth.
struct LeftInside {
    BlockLanes surfaces;  ///< outward normal; w depth [m], 0: in none
    std::array<std::uint32_t, block_size> colliders;
};

struct CollidingBlock {
    std::span<Vec4> positions, velocities;
    std::span<const Vec4> held, starts;  ///< see CollidingParticles
    BlockPaths paths;                    ///< paths of all finite particles, kept current as they are moved
    const ClothSide* cloth;              ///< properties of these particles towards the collider in work
    alignas(64) std::array<std::uint32_t, block_size> met{};  ///< 1 for a particle that met a collider
    std::uint32_t collider = 0;                               ///< index of the collider in work
    bool has_left = false;       ///< whether any is left inside; else `left` is not written
    LeftInside* left = nullptr;  ///< used where there are starts
};

/// Paths of the particles that are numbers. Without starts none has moved.
[[nodiscard]] BlockPaths paths_of(std::span<const Vec4> starts, std::span<const Vec4> positions);

/// collide_particles() of collider_contacts.h, for one block and one collider.
void collide(const MovingShape& shape, const ContactSettings& settings, CollidingBlock& block);

/// points = positions + gamma velocities. Returns their paths from `starts`, without those that are not
/// numbers. Without starts none has moved.
[[nodiscard]] BlockPaths place(std::span<const Vec4> starts, std::span<const Vec4> positions, float gamma,
                               std::span<const Vec4> velocities, BlockLanes& points);

/// Property, of cloth and collider together, that a search writes to w of a surface's motion.
enum class Told : std::uint8_t { friction, restitution };

/// A search for surfaces near a block of `size` particles. `starts` may be empty.
struct NearestSought {
    ContactSettings settings;
    const ClothSide& cloth;  ///< properties of these particles
    float reach;             ///< beyond the thickness [m]
    std::span<const Vec4> starts;
    std::uint32_t size;
    Told told;

    [[nodiscard]] float all() const { return settings.thickness + reach; }
};

/// Stores the surface for particles to which it is the nearest so far. Returns whether there are any.
[[nodiscard]] bool find_nearest(const MovingShape& shape, const NearestSought& sought, NearSurfaces& near);

}  // namespace weft
