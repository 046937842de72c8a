#pragma once
// Patches of sixteen particles that are close at rest, and so mostly stay close, and boxes around their
// present positions. Particles in boxes farther apart than a distance are farther apart, too.

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

/// A cloth cut into patches. Each block of particles has sixteen patches, which are close to one another.
/// Patch p is the slots [16 p, 16 p + 16). How well the cut fits the cloth's present shape affects only the
/// duration of a search.
class Patches {
  public:
    /// Precondition: positions at rest are finite.
    explicit Patches(std::span<const Vec4> rest_positions);

    /// Updates the positions in all patches, and the boxes.
    void place(Parallel& parallel, std::span<const Vec4> positions);

    [[nodiscard]] PatchesView view() const noexcept;
    /// The box around all finite particles, as last placed.
    [[nodiscard]] Bounds bounds() const noexcept;
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    std::uint32_t particle_count_;
    AlignedBuffer<std::uint32_t> particles_;  // by slot
    std::vector<Patch> patches_;
    std::vector<Boxes> patch_boxes_, block_boxes_, region_boxes_;  // see PatchesView
};

}  // namespace weft
