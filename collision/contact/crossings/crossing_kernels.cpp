#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "collision/contact/pairs/pair_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/contact/crossings/crossing_kernels.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "collision/contact/pairs/closest-inl.h"
#include "collision/contact/pairs/near_slots-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// Six times the volume of a tetrahedron, signed, in double precision. Computed from its corners in ascending
/// order of their numbers, so that all who ask about the same four get the same answer, rounding included: a
/// line that runs between two triangles meets one of them at least.
class Volumes {
  public:
    explicit Volumes(const Vec4* positions) : positions_(positions) {}

    [[nodiscard]] double of(std::array<std::uint32_t, 4> corners) const {
        double sign = 1;
        const auto order = [&](std::size_t i, std::size_t j) {
            if (corners[i] <= corners[j]) return;
            std::swap(corners[i], corners[j]);
            sign = -sign;
        };
        order(0, 1);
        order(2, 3);
        order(0, 2);
        order(1, 3);
        order(1, 2);
        double v[3][3];
        const Vec4& from = positions_[corners[0]];
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec4& to = positions_[corners[k + 1]];
            v[k][0] = double{to.x} - double{from.x};
            v[k][1] = double{to.y} - double{from.y};
            v[k][2] = double{to.z} - double{from.z};
        }
        return sign * (v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) +
                       v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
                       v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]));
    }

  private:
    const Vec4* positions_;
};

/// An end in the triangle's plane counts as one side's, the same for all edges there; a line through a side
/// or a corner of the triangle as within it.
bool crosses(const Volumes& volumes, const Crossing& c) {
    const auto& [p, q] = c.edge;
    std::array<std::uint32_t, 3> t = c.triangle;
    std::ranges::sort(t);
    if ((volumes.of({t[0], t[1], t[2], p}) >= 0) == (volumes.of({t[0], t[1], t[2], q}) >= 0)) return false;
    const double ab = volumes.of({p, q, t[0], t[1]}), bc = volumes.of({p, q, t[1], t[2]}),
                 ca = volumes.of({p, q, t[2], t[0]});
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
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
    Found<Crossing>& found;
    CrossingCandidates candidates;
    NearEdges edges;
    NearTriangles triangles;

    HWY_INLINE CrossingCollector(const PairSearch& s, Found<Crossing>& f) : search(s), found(f) {}

    /// Both ends are surely on one side of the plane: by more than rounding can be, which is some units in
    /// the last place of each product that makes up a volume.
    HWY_INLINE hn::Mask<Tag> surely_apart(std::uint32_t k) const {
        const auto point = [&](std::uint32_t c)
                               HWY_ATTR { return gather_rows(search.positions, candidates.corners[c] + k); };
        const Lanes3 a = point(2), ab = point(3) - a, ac = point(4) - a;
        const Lanes3 ap = point(0) - a, aq = point(1) - a, across = cross(ab, ac);
        const Lanes p = dot(across, ap), q = dot(across, aq);
        const Lanes size = hn::Mul(hn::Mul(sum_of_absolutes(ab), sum_of_absolutes(ac)),
                                   hn::Max(sum_of_absolutes(ap), sum_of_absolutes(aq)));
        const Lanes rounding = hn::Mul(set(1e-6f), size);
        return hn::Or(hn::Gt(hn::Min(p, q), rounding), hn::Lt(hn::Max(p, q), hn::Neg(rounding)));
    }

    /// Of candidate `first` + `lane`: rounding can make what is in one plane cross from afar.
    HWY_INLINE bool boxes_overlap(std::uint32_t first, std::uint32_t lane) const {
        const BoxLanes edge = placed_box(search, candidates.corners, 0, 2, first, 0);
        const BoxLanes triangle = placed_box(search, candidates.corners, 2, 5, first, 0);
        return (bits_of(overlap(edge, triangle)) >> lane & 1) != 0;
    }

    HWY_NOINLINE void test_all() {
        if (candidates.count == 0) return;
        for (auto& corner : candidates.corners)
            for (std::uint32_t k = 0; k < part_lanes; ++k) corner[candidates.count + k] = corner[0];
        const Volumes volumes(search.positions);
        const auto& c = candidates.corners;
        for (std::uint32_t k = 0; k < candidates.count; k += part_lanes) {
            const auto unsure = hn::AndNot(surely_apart(k), hn::FirstN(Tag(), candidates.count - k));
            for (std::uint32_t rest = bits_of(unsure); rest != 0; rest &= rest - 1) {
                const auto i = k + static_cast<std::uint32_t>(std::countr_zero(rest));
                const Crossing crossing{{c[0][i], c[1][i]}, {c[2][i], c[3][i], c[4][i]}};
                if (crosses(volumes, crossing) && boxes_overlap(k, i - k)) found.add(crossing);
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

void crossings(const PairSearch& search, std::uint32_t block, Found<Crossing>& found) {
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

void find_crossings(const PairSearch& search, std::uint32_t block, Found<Crossing>& found) {
    HWY_DYNAMIC_DISPATCH(crossings)(search, block, found);
}

}  // namespace weft
#endif
