#include "collision/search/patch_kernels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/search/patch_kernels.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "collision/search/boxes-inl.h"
#include "collision/search/compress-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

constexpr std::uint32_t parts = patch_size / part_lanes;

HWY_INLINE Lanes3 load_part(const Patch& patch, std::uint32_t first) {
    return {load_lanes(patch.x + first), load_lanes(patch.y + first), load_lanes(patch.z + first)};
}
/// Particles that are not finite, and padding, go to infinity: far from all others and from one another, as
/// the difference of two such positions is not a number.
HWY_INLINE BoxLanes place_part(const Vec4* positions, const std::uint32_t* particles, std::uint32_t count,
                               Patch& patch, std::uint32_t first) {
    const Tag d;
    const Lanes infinity = set(std::numeric_limits<float>::infinity());
    const Lanes3 p = gather_rows(positions, particles);
    const auto here = hn::And(is_finite(p), hn::FirstN(d, count));
    const Lanes3 lower = either(here, p, {infinity, infinity, infinity});
    hn::Store(lower.x, d, patch.x + first);
    hn::Store(lower.y, d, patch.y + first);
    hn::Store(lower.z, d, patch.z + first);
    const Lanes nowhere = hn::Neg(infinity);
    return {lower, either(here, p, {nowhere, nowhere, nowhere})};
}

HWY_INLINE Bounds place_patch(const Vec4* positions, const std::uint32_t* particles, std::uint32_t count,
                              Patch& patch) {
    BoxLanes box = place_part(positions, particles, count, patch, 0);
    for (std::uint32_t first = part_lanes; first < patch_size; first += part_lanes) {
        const std::uint32_t rest = count - std::min(count, first);
        box = join(box, place_part(positions, particles + first, rest, patch, first));
    }
    return hull_of_lanes(box);
}

Bounds around(const Boxes& boxes) {
    return hull_of(boxes);
}

Bounds place(std::span<const Vec4> positions, const std::uint32_t* particles, std::uint32_t count,
             Patch* patches, Boxes& boxes) {
    for (std::uint32_t p = 0; p < patches_per_block; ++p) {
        const std::uint32_t first = p * patch_size;
        const std::uint32_t here = std::min(count - std::min(count, first), patch_size);
        set_box(boxes, p, place_patch(positions.data(), particles + first, here, patches[p]));
    }
    return around(boxes);
}

/// Indices that passed a test, as many as there is room for.
template <std::uint32_t capacity>
struct Passed {
    std::uint32_t count = 0;
    std::array<std::uint32_t, capacity + 16> index;

    [[nodiscard]] bool is_full() const { return count > capacity; }
};

/// Appends first + k for the lanes k of the mask.
template <class Mask, class List>
HWY_INLINE void append(Mask mask, std::uint32_t first, List& list) {
    const IndexTag d;
    const Kept kept(hn::RebindMask(d, mask));
    hn::StoreU(kept.of_numbers_from(first), d, &list.index[list.count]);
    list.count += kept.count();
}

/// Appends first_index + k for those of the sixteen `boxes` that are within the distance of `box`.
template <class List>
HWY_INLINE void append_near(const BoxLanes& box, const Boxes& boxes, std::uint32_t first_index,
                            float distance, List& list) {
    for (std::uint32_t first = 0; first < 16; first += part_lanes)
        append(hn::Le(gap(box, load_boxes(boxes, first)), set(distance)), first_index + first, list);
}

using NearBlocks = Passed<1024>;
using NearPatches = Passed<256>;
using NearParticles = Passed<768>;
constexpr std::uint32_t patch_stride = sizeof(Patch) / sizeof(float);

/// Finds the blocks within the distance of `box`. Returns false if there are too many.
HWY_INLINE bool find_near_blocks(const PatchesView& view, const BoxLanes& box, float distance,
                                 NearBlocks& blocks) {
    NearBlocks regions;  // of sixteen blocks
    for (std::uint32_t k = 0; k < view.region_boxes.size(); ++k) {
        append_near(box, view.region_boxes[k], 16 * k, distance, regions);
        if (HWY_UNLIKELY(regions.is_full())) return false;
    }
    for (std::uint32_t k = 0; k < regions.count; ++k) {
        const std::uint32_t region = regions.index[k];
        append_near(box, view.block_boxes[region], 16 * region, distance, blocks);
        if (HWY_UNLIKELY(blocks.is_full())) return false;
    }
    return true;
}

/// The patch whose hits are searched.
struct Seeker {
    std::uint32_t patch;
    BoxLanes box;
    float distance;
};

/// Finds the particles within the distance of the seeker's box, those of its own patch among them. Their
/// indices are those of their x among the values of all patches. Returns false if there are too many.
HWY_INLINE bool find_near(const PatchesView& view, const Seeker& seeker, const NearBlocks& near_blocks,
                          NearParticles& particles) {
    NearPatches near;
    for (std::uint32_t k = 0; k < near_blocks.count; ++k) {
        const std::uint32_t block = near_blocks.index[k];
        append_near(seeker.box, view.patch_boxes[block], block * patches_per_block, seeker.distance, near);
        if (HWY_UNLIKELY(near.is_full())) return false;
    }
    for (std::uint32_t k = 0; k < near.count; ++k) {
        const std::uint32_t patch = near.index[k];
        for (std::uint32_t first = 0; first < patch_size; first += part_lanes) {
            const Lanes3 p = load_part(view.patches[patch], first);
            append(hn::Le(gap(seeker.box, {p, p}), set(seeker.distance)), patch * patch_stride + first,
                   particles);
        }
        if (HWY_UNLIKELY(particles.is_full())) return false;
    }
    return true;
}

/// Sets bit k of `bits` if particle k of the patch is closer to the point than the distance.
HWY_INLINE void store_close(const Lanes3 (&patch)[parts], const Lanes3& point, float distance_squared,
                            std::uint16_t& bits) {
    const Tag d;
    std::uint8_t bytes[parts][8];
    for (std::uint32_t k = 0; k < parts; ++k)
        hn::StoreMaskBits(d, hn::Lt(squared_length(patch[k] - point), set(distance_squared)), bytes[k]);
    if constexpr (parts == 1) {
        std::memcpy(&bits, bytes, sizeof bits);
    } else {
        std::uint32_t all = 0;
        for (std::uint32_t k = 0; k < parts; ++k) all |= std::uint32_t{bytes[k][0]} << (k * part_lanes);
        bits = static_cast<std::uint16_t>(all);
    }
}

/// Particles near a patch, and bits for the patch's particles to which they are close.
struct Company {
    std::uint32_t count = 0;
    std::array<std::uint32_t, NearParticles().index.size()> particle, bits;
};

/// Finds the near particles that are close to any of the patch. Few are: no branch depends on it.
HWY_INLINE void find_company(const PatchesView& view, const Seeker& seeker, const NearParticles& near,
                             Company& company) {
    Lanes3 patch[parts];
    for (std::uint32_t k = 0; k < parts; ++k)
        patch[k] = load_part(view.patches[seeker.patch], k * part_lanes);
    const float* const values = view.patches.data()->x;
    alignas(64) std::array<std::uint16_t, NearParticles().index.size()> bits_of;
    for (std::uint32_t k = 0; k < near.count; ++k) {
        const float* const at = values + near.index[k];
        const Lanes3 point = {set(at[0]), set(at[patch_size]), set(at[2 * patch_size])};
        store_close(patch, point, seeker.distance * seeker.distance, bits_of[k]);
    }

    const IndexTag d;
    const hn::Rebind<std::uint16_t, IndexTag> halves;
    for (std::uint32_t k = 0; k < near.count; k += part_lanes) {
        const Indices particle = hn::LoadU(d, &near.index[k]);
        const Indices lane = hn::Sub(particle, set_index(seeker.patch * patch_stride));
        const auto is_own = hn::Lt(lane, set_index(patch_size));
        const Indices itself =
            hn::IfThenElseZero(is_own, hn::Shl(set_index(1), hn::And(lane, set_index(patch_size - 1))));
        const Indices bits = hn::AndNot(itself, hn::PromoteTo(d, hn::LoadU(halves, &bits_of[k])));
        const Kept close(hn::And(hn::Ne(bits, set_index(0)), hn::FirstN(d, near.count - k)));
        hn::StoreU(close.of(particle), d, &company.particle[company.count]);
        hn::StoreU(close.of(bits), d, &company.bits[company.count]);
        company.count += close.count();
    }
}

std::uint32_t slot_of(std::uint32_t particle) {
    return particle / patch_stride * patch_size + particle % patch_stride;
}

/// Adds the hits of one patch. Returns false, and adds nothing, if the patch is left out.
HWY_INLINE bool add_hits_of_patch(const PatchesView& view, const Seeker& seeker,
                                  const NearBlocks& near_blocks, BlockHits& hits) {
    NearParticles near;
    if (HWY_UNLIKELY(!find_near(view, seeker, near_blocks, near))) return false;
    Company company;
    find_company(view, seeker, near, company);

    const std::uint32_t* const particles = view.particles + seeker.patch * patch_size;
    std::array<std::uint32_t, patch_size> counts{};
    std::uint32_t count = hits.count;
    for (std::uint32_t k = 0; k < company.count; ++k) {
        const std::uint32_t other = view.particles[slot_of(company.particle[k])];
        for (std::uint32_t bits = company.bits[k]; bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::uint32_t>(std::countr_zero(bits));
            if (HWY_UNLIKELY(++counts[lane] > BlockHits::per_slot)) return false;
            hits.particles[count] = particles[lane];
            hits.others[count++] = other;
        }
    }
    hits.count = count;
    return true;
}

std::uint32_t find(const PatchesView& view, float distance, std::uint32_t block, BlockHits& hits) {
    const BoxLanes block_box = box_of(view.block_boxes[block / 16], block % 16);
    hits.count = 0;
    NearBlocks near_blocks;
    if (HWY_UNLIKELY(!find_near_blocks(view, block_box, distance, near_blocks)))
        return (1u << patches_per_block) - 1;
    std::uint32_t left_out = 0;
    for (std::uint32_t p = 0; p < patches_per_block; ++p) {
        const Seeker seeker{block * patches_per_block + p, box_of(view.patch_boxes[block], p), distance};
        if (HWY_UNLIKELY(!add_hits_of_patch(view, seeker, near_blocks, hits))) left_out |= 1u << p;
    }
    return left_out;
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace weft {

HWY_EXPORT(place);
HWY_EXPORT(around);
HWY_EXPORT(find);

Bounds place_block(std::span<const Vec4> positions, const std::uint32_t* particles, std::uint32_t count,
                   Patch* patches, Boxes& boxes) {
    return HWY_DYNAMIC_DISPATCH(place)(positions, particles, count, patches, boxes);
}

Bounds hull(const Boxes& boxes) {
    return HWY_DYNAMIC_DISPATCH(around)(boxes);
}

std::uint32_t find_hits_in_patches(const PatchesView& patches, float distance, std::uint32_t block,
                                   BlockHits& hits) {
    return HWY_DYNAMIC_DISPATCH(find)(patches, distance, block, hits);
}

}  // namespace weft
#endif
