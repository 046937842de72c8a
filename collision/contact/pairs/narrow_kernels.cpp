// Narrowing of a list of pairs, many at a time; compiled once for each kind of machine.

#include <algorithm>
#include <bit>

#include "collision/contact/pairs/pair_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/contact/pairs/narrow_kernels.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "collision/contact/pairs/candidates-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// Pairs of a list that are tested together, and their numbers in the list.
struct Batch {
    Candidates candidates;
    std::uint32_t numbers[group_lanes];
    alignas(64) float normals[3][group_lanes] = {};

    void add(std::uint32_t number, const FeaturePair& pair, const Vec4& normal) {
        const std::uint32_t k = candidates.count++;
        numbers[k] = number;
        for (std::uint32_t c = 0; c < 4; ++c) candidates.corners[c][k] = pair.corners[c];
        normals[0][k] = normal.x;
        normals[1][k] = normal.y;
        normals[2][k] = normal.z;
    }
};

/// The box around corners over their motion.
HWY_INLINE BoxLanes swept_box(const CornerLanes& corners, std::uint32_t first, std::uint32_t end) {
    const Lanes3 start = corners.point[first], moved = start + corners.motion[first];
    BoxLanes box = join({start, start}, {moved, moved});
    for (std::uint32_t c = first + 1; c < end; ++c) {
        const Lanes3 x = corners.point[c], y = x + corners.motion[c];
        box = join(box, join({x, x}, {y, y}));
    }
    return box;
}

template <std::uint32_t of_a>
HWY_INLINE std::uint32_t left_of(const PairNarrow& narrow, Batch& batch) {
    pad(batch.candidates);
    const CornerLanes corners = gather_corners(narrow.positions, narrow.motions, batch.candidates, 0);
    const Lanes3 normal = {load_lanes(batch.normals[0]), load_lanes(batch.normals[1]),
                           load_lanes(batch.normals[2])};
    const Lanes reach = set(narrow.reach);
    const Lanes3 margin = {reach, reach, reach};
    const BoxLanes a = swept_box(corners, 0, of_a), b = swept_box(corners, of_a, 4);
    const auto is_left = hn::And(hn::Lt(swept_gap_along<of_a>(normal, corners), reach),
                                 overlap({a.lower - margin, a.upper + margin}, b));
    return bits_of(hn::And(is_left, hn::FirstN(Tag(), batch.candidates.count)));
}

template <std::uint32_t of_a>
HWY_INLINE std::uint32_t narrow_list(const PairNarrow& narrow, std::span<FeaturePair> pairs,
                                     PairShape* shapes) {
    Batch batch;
    std::uint32_t kept = 0;
    const float too_far =
        narrow.reach + 2 * narrow.longest;  // no motion brings a pair with a larger gap within reach
    for (std::uint32_t k = 0; k < pairs.size(); ++k) {
        if (!(shapes[k].normal.w > too_far)) batch.add(k, pairs[k], shapes[k].normal);
        if (batch.candidates.count < part_lanes && k + 1 < pairs.size()) continue;
        if (batch.candidates.count == 0) continue;
        for (std::uint32_t left = left_of<of_a>(narrow, batch); left != 0; left &= left - 1) {
            const std::uint32_t from = batch.numbers[std::countr_zero(left)];
            pairs[kept] = pairs[from];
            shapes[kept++] = shapes[from];
        }
        batch.candidates.count = 0;
    }
    return kept;
}

std::uint32_t narrow(const PairNarrow& to, bool vertex_triangle, std::span<FeaturePair> pairs,
                     PairShape* shapes) {
    return vertex_triangle ? narrow_list<vertex_and_triangle>(to, pairs, shapes)
                           : narrow_list<edge_and_edge>(to, pairs, shapes);
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace weft {

HWY_EXPORT(narrow);

std::uint32_t narrow_pairs(const PairNarrow& to, bool vertex_triangle, std::span<FeaturePair> pairs,
                           PairShape* shapes) {
    return HWY_DYNAMIC_DISPATCH(narrow)(to, vertex_triangle, pairs, shapes);
}

}  // namespace weft
#endif
