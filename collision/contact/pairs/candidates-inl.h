// Candidate pairs of features for the exact tests, many at a time. Included as engine/simd/lanes-inl.h is.

#if defined(WEFT_COLLISION_CONTACT_PAIRS_CANDIDATES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_COLLISION_CONTACT_PAIRS_CANDIDATES_INL_H
#undef WEFT_COLLISION_CONTACT_PAIRS_CANDIDATES_INL_H
#else
#define WEFT_COLLISION_CONTACT_PAIRS_CANDIDATES_INL_H
#endif

#include "collision/contact/pairs/near_slots-inl.h"
#include "collision/geometry/closest-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// Pairs of features whose boxes overlap.
struct Candidates {
    static constexpr std::uint32_t full = 512, capacity = full + ContactPatch::most_edges + group_lanes;

    std::uint32_t count = 0;
    alignas(64) std::uint32_t corners[4][capacity];
};

HWY_INLINE CornerLanes gather_corners(const Vec4* positions, const Vec4* motions, const Candidates& of,
                                      std::uint32_t first) {
    CornerLanes corners;
    const Lanes3 origin = gather_rows(positions, of.corners[0] + first);
    corners.point[0] = zero3();
    for (std::uint32_t c = 1; c < 4; ++c)
        corners.point[c] = gather_rows(positions, of.corners[c] + first) - origin;
    for (std::uint32_t c = 0; c < 4; ++c)
        corners.motion[c] = motions == nullptr ? zero3() : gather_rows(motions, of.corners[c] + first);
    return corners;
}

/// Padding: lanes past the end repeat the first candidate.
HWY_INLINE void pad(Candidates& candidates) {
    for (auto& corner : candidates.corners)
        for (std::uint32_t k = 0; k < part_lanes; ++k) corner[candidates.count + k] = corner[0];
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
