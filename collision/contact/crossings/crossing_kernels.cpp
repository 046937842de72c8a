#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "collision/contact/pairs/pair_kernels.h"
#include "collision/geometry/volume_sign.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/contact/crossings/crossing_kernels.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "collision/contact/pairs/near_slots-inl.h"
#include "collision/geometry/closest-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// Whether the ends of the edge lie strictly on two sides of the triangle's plane, and the line through them
/// meets the triangle or its border. An edge that ends on the triangle, or lies in its plane, only touches.
bool crosses(const Vec4* positions, const Crossing& c) {
    const auto sign = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t l) {
        return volume_sign(positions[i], positions[j], positions[k], positions[l]);
    };
    const auto& [p, q] = c.edge;
    const auto& [a, b, d] = c.triangle;
    if (sign(a, b, d, p) * sign(a, b, d, q) >= 0) return false;
    const int ab = sign(p, q, a, b), bd = sign(p, q, b, d), da = sign(p, q, d, a);
    return std::min({ab, bd, da}) >= 0 || std::max({ab, bd, da}) <= 0;
}

HWY_INLINE Lanes sum_of_absolutes(const Lanes3& v) {
    return hn::Add(hn::Abs(v.x), hn::Add(hn::Abs(v.y), hn::Abs(v.z)));
}

/// Edges and triangles whose boxes overlap: the edge's ends, then the triangle's corners.
struct CrossingCandidates {
    static constexpr std::uint32_t full = 256, capacity = full + ContactPatch::most_triangles + group_lanes;

    std::uint32_t count = 0;
    alignas(64) std::uint32_t corners[5][capacity];
};

struct CrossingCollector {
    const PairSearch& search;
    FoundCrossings& found;
    CrossingCandidates candidates;
    NearEdges edges;
    NearTriangles triangles;

    HWY_INLINE CrossingCollector(const PairSearch& s, FoundCrossings& f) : search(s), found(f) {}

    /// Whether a plane across one of five axes separates edge and triangle by more than the rounding error.
    /// The axes are the triangle's normal and, in its plane, the normals of its three sides and of the edge.
    /// Features of flat pieces, which no sign of a volume separates, thus need no volumes.
    HWY_INLINE hn::Mask<Tag> surely_apart(std::uint32_t k) const {
        const auto point = [&](std::uint32_t c)
                               HWY_ATTR { return gather_rows(search.positions, candidates.corners[c] + k); };
        const Lanes3 a = point(2), b = point(3) - a, c = point(4) - a, p = point(0) - a, q = point(1) - a;
        const Lanes3 normal = cross(b, c);
        // The rounding error: some units in the last place of each product in a value along an axis.
        const Lanes width = hn::Max(hn::Max(sum_of_absolutes(b), sum_of_absolutes(c)),
                                    hn::Max(sum_of_absolutes(p), sum_of_absolutes(q)));
        const auto rounding = [&](Lanes axis) HWY_ATTR {
            return hn::MulAdd(set(1e-6f), hn::Mul(axis, width), set(1e-36f));
        };
        const Lanes of_normal = hn::Mul(sum_of_absolutes(b), sum_of_absolutes(c));
        const Lanes zero = set(0);
        const auto apart_along = [&](const Lanes3& axis, Lanes size) HWY_ATTR {
            const Lanes at_b = dot(axis, b), at_c = dot(axis, c), at_p = dot(axis, p), at_q = dot(axis, q);
            const Lanes above = hn::Sub(hn::Min(at_p, at_q), hn::Max(zero, hn::Max(at_b, at_c)));
            const Lanes below = hn::Sub(hn::Min(zero, hn::Min(at_b, at_c)), hn::Max(at_p, at_q));
            return hn::Gt(hn::Max(above, below), rounding(size));
        };
        auto apart = apart_along(normal, of_normal);
        for (const Lanes3& along : {q - p, b, c, c - b}) {
            if (hn::AllTrue(Tag(), apart)) break;
            const Lanes size = hn::Mul(set(4), hn::Mul(of_normal, sum_of_absolutes(along)));
            apart = hn::Or(apart, apart_along(cross(normal, along), size));
        }
        return apart;
    }

    HWY_NOINLINE void test_all() {
        if (candidates.count == 0) return;
        for (auto& corner : candidates.corners)
            for (std::uint32_t k = 0; k < part_lanes; ++k) corner[candidates.count + k] = corner[0];
        const auto& c = candidates.corners;
        for (std::uint32_t k = 0; k < candidates.count; k += part_lanes) {
            const auto unsure = hn::AndNot(surely_apart(k), hn::FirstN(Tag(), candidates.count - k));
            for (std::uint32_t rest = bits_of(unsure); rest != 0; rest &= rest - 1) {
                const auto i = k + static_cast<std::uint32_t>(std::countr_zero(rest));
                const Crossing crossing{{c[0][i], c[1][i]}, {c[2][i], c[3][i], c[4][i]}};
                if (crosses(search.positions, crossing)) found.add(crossing);
            }
        }
        candidates.count = 0;
    }

    HWY_INLINE void pair_edges_with_triangles(const SearchedPatch& of_edges,
                                              const SearchedPatch& of_triangles) {
        const CoarsePlaces places(of_edges.box, of_triangles.box);
        of_edges.select(*search.boxes, of_triangles.box, places, edges);
        if (edges.count == 0) return;
        of_triangles.select(*search.boxes, of_edges.box, places, triangles);
        const IndexTag d;
        for (std::uint32_t i = 0; i < edges.count; ++i) {
            const CoarseBox box(edges, i);
            const Indices p = set_index(edges.corners[0][i]), q = set_index(edges.corners[1][i]);
            for (std::uint32_t k = 0; k < triangles.count; k += part_lanes) {
                auto near = box.may_overlap(triangles, k);
                Indices corner[3];
                for (std::uint32_t c = 0; c < 3; ++c) {
                    corner[c] = hn::Load(d, triangles.corners[c] + k);
                    near = hn::AndNot(hn::Or(hn::Eq(p, corner[c]), hn::Eq(q, corner[c])), near);
                }
                if (hn::AllFalse(d, near)) continue;
                const Kept kept(near);
                const Indices items[5] = {p, q, corner[0], corner[1], corner[2]};
                for (std::uint32_t c = 0; c < 5; ++c)
                    hn::StoreU(kept.of(items[c]), d, candidates.corners[c] + candidates.count);
                candidates.count += kept.count();
            }
            if (HWY_UNLIKELY(candidates.count >= CrossingCandidates::full)) test_all();
        }
    }
};

void crossings(const PairSearch& search, std::uint32_t block, FoundCrossings& found) {
    CrossingCollector collector(search, found);
    for_each_near_patch(search, block,
                        [&](const SearchedPatch& a, const SearchedPatch& b, bool is_same) HWY_ATTR {
                            collector.pair_edges_with_triangles(a, b);
                            if (!is_same) collector.pair_edges_with_triangles(b, a);
                        });
    collector.test_all();
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace weft {

HWY_EXPORT(crossings);

void find_crossings(const PairSearch& search, std::uint32_t block, FoundCrossings& found) {
    HWY_DYNAMIC_DISPATCH(crossings)(search, block, found);
}

}  // namespace weft
#endif
