#pragma once
// Whole triangles of a cloth against thin and sharp colliders. Particles are met on their way by collide();
// what passes between them is not.

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

    /// mean_edge: at rest [m]. The triangles are to outlive it. May throw.
    WholeTriangles(std::span<const Triangle> triangles, std::uint32_t particles, float mean_edge);

    /// After collide() has moved particles: what their triangles' sides and insides have passed of colliders
    /// that are thin beside the cloth's edges, or sharp, is put back to the side on which it came, as far as
    /// half the thickness, with velocities as in collide(). Momentum goes to corners by their masses.
    /// What the axis of a limb goes through when that is done comes off over its end.
    /// Returns how many sides, insides and triangles were moved. The rest as there; `starts` may not be
    /// empty.
    std::uint32_t keep_out(Parallel& parallel, std::span<const ColliderMotion> colliders,
                           const ClothSide& cloth, float h, const CollidingParticles& particles);

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
    /// Of the cloth at these positions [m].
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
    AlignedBuffer<std::uint32_t> order_;  // of triangles, by their first particles: so blocks lie together
    float mean_edge_;
    AlignedBuffer<std::uint8_t> owned_;    // by triangle: bit k of its side from corner k to the next
    AlignedBuffer<ParticleSpan> spans_;    // by block of triangles: their particles
    AlignedBuffer<std::uint32_t> near_;    // triangles, from each block's begin on
    AlignedBuffer<std::uint32_t> counts_;  // of these, by block
    AlignedBuffer<std::uint8_t> is_fast_;  // whether any of these is, by block
    AlignedBuffer<float> longest_;         // of edges, by block
    AlignedBuffer<BlockPaths> paths_;      // by block of particles
};

}  // namespace weft
