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

/// Depth in which a substep finds a particle when it begins, as where a collider has been placed over it. The
/// equation lets it be, so that it becomes no velocity; collide() takes it out at a limited speed, and leaves
/// it where another collider holds the particle.
struct FoundDepth {
    static constexpr float speed = 0.1f;  ///< [m/s]
    static constexpr float rate = 2;      ///< if that is more, this part of the depth [1/s]

    /// What is less goes as depth that the substep brings [m].
    float least = std::numeric_limits<float>::infinity();
};

struct ContactSettings {
    float thickness;                          ///< of collider and cloth together the most [m]
    float friction;                           ///< of the collider
    float h;                                  ///< [s]
    float restitution = 0, least_bounce = 0;  ///< of both; what comes slower [m/s] does not bounce
    FoundDepth found{};
    /// Particles that move farther than `thin` against the shape can pass it: their way is looked at. 0: none
    /// of the block moves as far.
    Meeting meeting{};
};

/// What particles of a block have been left inside of: of several the deepest.
struct LeftInside {
    BlockLanes surfaces;  ///< outward normal; w depth [m], 0: in none
    std::array<std::uint32_t, block_size> colliders;
};

struct CollidingBlock {
    std::span<Vec4> positions, velocities;
    std::span<const Vec4> held, starts;  ///< see CollidingParticles
    BlockPaths paths;                    ///< of all that are finite, also after they were moved
    const ClothSide& cloth;              ///< of these particles
    alignas(64) std::array<std::uint32_t, block_size> met{};  ///< 1 for a particle that met a collider
    std::uint32_t collider = 0;                               ///< the number of the one that is met
    bool has_left = false;                                    ///< any; else `left` is not written
    LeftInside* left = nullptr;                               ///< where there are starts
};

/// Of those that are numbers. No starts: none has moved.
[[nodiscard]] BlockPaths paths_of(std::span<const Vec4> starts, std::span<const Vec4> positions);

/// collide() of collider_contacts.h, for one block and one collider.
void collide(const MovingCapsule& capsule, const ContactSettings& settings, CollidingBlock& block);
void collide(const MovingTaperedCapsule& capsule, const ContactSettings& settings, CollidingBlock& block);
void collide(const MovingPlane& plane, const ContactSettings& settings, CollidingBlock& block);
void collide(const MovingBox& box, const ContactSettings& settings, CollidingBlock& block);
void collide(const MovingHeld& held, const ContactSettings& settings, CollidingBlock& block);

/// points = positions + gamma velocities. Returns their paths from `starts`, of those that are numbers. No
/// starts: none has moved.
[[nodiscard]] BlockPaths place(std::span<const Vec4> starts, std::span<const Vec4> positions, float gamma,
                               std::span<const Vec4> velocities, BlockLanes& points);

/// Which property of cloth and collider together a search writes to w of a surface's motion.
enum class Told : std::uint8_t { friction, restitution };

/// Of a block of `size` particles with these starts, if they are swept.
struct NearestSought {
    ContactSettings settings;
    const ClothSide& cloth;  ///< of these particles
    float reach;             ///< beyond the thickness [m]
    std::span<const Vec4> starts;
    std::uint32_t size;
    Told told;

    [[nodiscard]] float all() const { return settings.thickness + reach; }
};

/// Takes the surface where it is nearer than what the block has, and returns whether it is near any.
[[nodiscard]] bool find_nearest(const MovingCapsule& capsule, const NearestSought& sought,
                                NearSurfaces& near);
[[nodiscard]] bool find_nearest(const MovingTaperedCapsule& capsule, const NearestSought& sought,
                                NearSurfaces& near);
[[nodiscard]] bool find_nearest(const MovingPlane& plane, const NearestSought& sought, NearSurfaces& near);
[[nodiscard]] bool find_nearest(const MovingBox& box, const NearestSought& sought, NearSurfaces& near);
[[nodiscard]] bool find_nearest(const MovingHeld& held, const NearestSought& sought, NearSurfaces& near);

}  // namespace weft
