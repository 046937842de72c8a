#pragma once
// Whole triangles of a cloth against thin and sharp colliders, which pass between the particles that
// collide() tests along their paths.

#include <array>
#include <cstdint>
#include <span>

#include "collision/colliders/collider_contacts.h"
#include "collision/shapes/moving_shapes.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

class Cores;
class Skewer;

class WholeTriangles {
  public:
    using Triangle = std::array<std::uint32_t, 3>;  ///< particles

    /// mean_edge: mean edge length at rest [m]. The triangles must outlive the object. May throw.
    WholeTriangles(std::span<const Triangle> triangles, std::uint32_t particles, float mean_edge);

    /// Call this after collide() has moved particles. Sides and insides of triangles that have passed
    /// colliders that are sharp, or thin beside the cloth's edges, are pushed back to the side from which
    /// they came, to half the thickness, with velocities as in collide(). Corners share momentum by their
    /// masses. Triangles that a limb's axis still pierces come off over its end. Returns the number of sides,
    /// insides and triangles that were moved. All else as there; `starts` may not be empty.
    std::uint32_t keep_out(Parallel& parallel, std::span<const ColliderMotion> colliders,
                           const ClothSide& cloth, float h, const CollidingParticles& particles);

    [[nodiscard]] std::span<const Triangle> triangles() const noexcept { return triangles_; }
    [[nodiscard]] float mean_edge() const noexcept { return mean_edge_; }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return order_.bytes() + owned_.bytes() + spans_.bytes() + near_.bytes() + counts_.bytes() +
               is_fast_.bytes() + longest_.bytes() + paths_.bytes();
    }

  private:
    struct ParticleSpan {
        std::uint32_t first, last;
    };
    struct Meeting;

    void find_owned();
    /// The cloth's longest edge at these positions [m].
    [[nodiscard]] float longest_edge(Parallel& parallel, std::span<const Vec4> positions);
    [[nodiscard]] BlockPaths find_paths(Parallel& parallel, const CollidingParticles& particles);
    [[nodiscard]] BlockPaths joined(std::uint32_t first, std::uint32_t last) const;
    std::uint32_t find_near(Parallel& parallel, const Meeting& meeting);
    void find_near_in_block(const Meeting& meeting, const BlockRange& range);
    std::uint32_t push_out(const Meeting& meeting, std::uint32_t near);
    bool push_out_triangle(const Meeting& meeting, std::uint32_t triangle);
    std::uint32_t find_pierced(Parallel& parallel, const Skewer& skewer, const Meeting& meeting);
    std::uint32_t take_off(Parallel& parallel, const Meeting& meeting,
                           std::span<const ColliderMotion> colliders);
    std::uint32_t gather_near();

    std::span<const Triangle> triangles_;
    AlignedBuffer<std::uint32_t> order_;  // triangles sorted by first particle, which keeps blocks compact
    float mean_edge_;
    AlignedBuffer<std::uint8_t> owned_;    // by triangle: bit k if it owns its side from corner k on
    AlignedBuffer<ParticleSpan> spans_;    // by block of triangles: their particles
    AlignedBuffer<std::uint32_t> near_;    // near triangles, from each block's begin on
    AlignedBuffer<std::uint32_t> counts_;  // number of near triangles, by block
    AlignedBuffer<std::uint8_t> is_fast_;  // whether any near triangle is fast, by block
    AlignedBuffer<float> longest_;         // longest edge, by block
    AlignedBuffer<BlockPaths> paths_;      // paths, by block of particles
};

}  // namespace weft
