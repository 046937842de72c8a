#pragma once
// A block of particles against one collider, many particles at a time; compiled once for each kind of
// machine.

#include <array>
#include <cstdint>
#include <span>

#include "collision/collider_contacts.h"
#include "engine/parallel_blocks.h"
#include "engine/vector.h"
#include "weft/types.h"

namespace weft {

/// A capsule, or a sphere (axis 0), at a substep's end, and how it comes there.
struct MovingCapsule {
    Vector3 a, axis;               ///< [m]; from a to b
    float per_length_squared;      ///< 1 / axis^2; 0 for a sphere
    float radius;                  ///< [m]
    float growth;                  ///< of the radius [m/s]
    Vector3 velocity, difference;  ///< of a, and what b's is more [m/s]
    Vector3 across;                ///< the way out for a point on the axis
    Vector3 start_a, start_axis;   ///< at the substep's start [m]
    float per_start_length_squared;
    float start_radius;  ///< [m]
    Matrix3 turn;        ///< from then to now
};

/// A half space normal . p <= offset at a substep's end. Its surface moves along the normal, at p by
/// (advance - turn . p): how it slides in itself cannot be told from its two ends.
struct MovingPlane {
    Vector3 normal;
    float offset;   ///< [m]
    float advance;  ///< [m/s]
    Vector3 turn;   ///< [1/s]
    float fastest;  ///< [m/s]
};

struct ContactSettings {
    float thickness;  ///< [m]
    float friction;   ///< of cloth and collider together
    float h;          ///< [s]
    /// Particles that move farther than this against the shape can pass it [m]: their way is looked at. 0:
    /// none of the block moves as far.
    float thin = 0;
};

/// Where a block's particles end, and how far the farthest has gone.
struct BlockPaths {
    Bounds ends;
    float longest;  ///< [m]
};

struct CollidingBlock {
    std::span<Vec4> positions, velocities;
    std::span<const Vec4> held, starts;  ///< see collide()
    BlockPaths paths;                    ///< of all that are finite, also after they were moved
    alignas(64) std::array<std::uint32_t, block_size> met{};  ///< 1 for a particle that met a collider
};

/// Of those that are numbers. No starts: none has moved.
[[nodiscard]] BlockPaths paths_of(std::span<const Vec4> starts, std::span<const Vec4> positions);

/// collide() of collider_contacts.h, for one block and one collider.
void collide(const MovingCapsule& capsule, const ContactSettings& settings, CollidingBlock& block);
void collide(const MovingPlane& plane, const ContactSettings& settings, CollidingBlock& block);

/// points = positions + gamma velocities. Returns their paths from `starts`, of those that are numbers. No
/// starts: none has moved.
[[nodiscard]] BlockPaths place(std::span<const Vec4> starts, std::span<const Vec4> positions, float gamma,
                               std::span<const Vec4> velocities, BlockLanes& points);

/// Takes the surface where it is nearer than what a block of `size` particles has, and returns whether it is
/// near any. `reach` is beyond the thickness [m].
[[nodiscard]] bool find_nearest(const MovingCapsule& capsule, const ContactSettings& settings, float reach,
                                std::span<const Vec4> starts, std::uint32_t size, NearSurfaces& near);
[[nodiscard]] bool find_nearest(const MovingPlane& plane, const ContactSettings& settings, float reach,
                                std::span<const Vec4> starts, std::uint32_t size, NearSurfaces& near);

}  // namespace weft
