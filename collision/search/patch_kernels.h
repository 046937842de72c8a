#pragma once
// Kernels that place patches and find close particles, many at a time; compiled once for each kind of
// machine. See patches.h.

#include <cstdint>
#include <limits>
#include <span>

#include "collision/search/search_kernels.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

inline constexpr std::uint32_t patch_size = 16, patches_per_block = block_size / patch_size;
static_assert(patches_per_block == 16, "a block's boxes are one Boxes");

/// Positions of a patch's particles [m]. Padding, and particles with a coordinate that is not finite, are at
/// infinity.
struct alignas(64) Patch {
    float x[patch_size], y[patch_size], z[patch_size];
};

/// Sixteen axis-aligned boxes [m]. A box without particles has lower = inf and upper = -inf.
struct alignas(64) Boxes {
    float lower_x[16], lower_y[16], lower_z[16];
    float upper_x[16], upper_y[16], upper_z[16];
};

inline constexpr float no_place = std::numeric_limits<float>::infinity();
inline constexpr Bounds no_box{{no_place, no_place, no_place}, {-no_place, -no_place, -no_place}};

inline void set_box(Boxes& boxes, std::uint32_t k, const Bounds& box) {
    boxes.lower_x[k] = box.lower.x;
    boxes.lower_y[k] = box.lower.y;
    boxes.lower_z[k] = box.lower.z;
    boxes.upper_x[k] = box.upper.x;
    boxes.upper_y[k] = box.upper.y;
    boxes.upper_z[k] = box.upper.z;
}

struct PatchesView {
    std::span<const Patch> patches;
    /// Boxes of patches, of blocks, and of regions of sixteen blocks: box k is in Boxes k / 16.
    std::span<const Boxes> patch_boxes, block_boxes, region_boxes;
    const std::uint32_t* particles;  ///< by slot
};

/// Fills a block's patches and boxes; `particles` are those of its slots, sixteen for every patch, the first
/// `count` of which are the cloth's. Returns the block's own box.
Bounds place_block(std::span<const Vec4> positions, const std::uint32_t* particles, std::uint32_t count,
                   Patch* patches, Boxes& boxes);

/// The box around all sixteen boxes.
Bounds hull(const Boxes& boxes);

/// Finds the hits of all particles of a block. Returns the patches that were left out, one bit each: those
/// with a particle that has more than BlockHits::per_slot, or with too many candidates for this search.
std::uint32_t find_hits_in_patches(const PatchesView& patches, float distance, std::uint32_t block,
                                   BlockHits& hits);

}  // namespace weft
