#pragma once
// Patches: sixteen particles each that lie together at rest, and so mostly stay together, and the boxes that
// they are in now. Where boxes are farther apart than a distance, so are all their particles.

#include <cstdint>
#include <span>
#include <vector>

#include "collision/search/patch_kernels.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

/// Puts particles in order of patches: each sixteen lie together at rest, and so does each block of them.
/// Precondition: positions at rest are finite.
void order_in_patches(std::span<std::uint32_t> particles, std::span<const Vec4> rest_positions);

/// A cloth cut into patches, and sixteen patches, which again lie together, to each block of particles. Patch
/// p is the slots [16 p, 16 p + 16). How well the cut fits the cloth as it lies now decides how long a search
/// takes, and nothing else.
class Patches {
  public:
    /// Precondition: positions at rest are finite.
    explicit Patches(std::span<const Vec4> rest_positions);

    /// Takes over where particles are now, and with them the boxes.
    void place(Parallel& parallel, std::span<const Vec4> positions);

    [[nodiscard]] PatchesView view() const noexcept;
    /// Of all particles that are finite, as last placed.
    [[nodiscard]] Bounds bounds() const noexcept;
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    std::uint32_t particle_count_;
    AlignedBuffer<std::uint32_t> particles_;  // by slot
    std::vector<Patch> patches_;
    std::vector<Boxes> patch_boxes_, block_boxes_, region_boxes_;  // see PatchesView
};

}  // namespace weft
