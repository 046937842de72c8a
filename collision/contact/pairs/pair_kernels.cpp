#include "collision/contact/pairs/pair_kernels.h"

#include <algorithm>
#include <bit>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/contact/pairs/pair_kernels.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "collision/contact/pairs/candidates-inl.h"
#include "collision/contact/pairs/near_slots-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// The reach of a search for pairs of two bodies' features: the mean of the bodies' reaches, and the margins
/// by which their boxes are grown.
struct PairReach {
    float mean = 0, half_of_a = 0, half_of_b = 0;

    PairReach() = default;
    PairReach(const SearchedBody& a, const SearchedBody& b)
        : mean(0.5f * (a.reach + b.reach)), half_of_a(half_reach_of(a)), half_of_b(half_reach_of(b)) {}
    bool operator==(const PairReach&) const = default;
};

/// Whether the boxes of sides A and B overlap, for the candidates from `first` on.
template <std::uint32_t of_a>
HWY_NOINLINE hn::Mask<Tag> boxes_overlap(const PairSearch& search, const PairReach& reach,
                                         const Candidates& of, std::uint32_t first) {
    return overlap(placed_box(search, of.corners, 0, of_a, first, reach.half_of_a),
                   placed_box(search, of.corners, of_a, 4, first, reach.half_of_b));
}

/// Adds the candidates that come within reach to `found`, and empties their list.
template <std::uint32_t of_a>
HWY_NOINLINE void test_candidates(const PairSearch& search, const PairReach& reach, Candidates& candidates,
                                  PairsOfBlock& found) {
    if (found.has_enough()) {
        candidates.count = 0;
        return;
    }
    pad(candidates);
    for (std::uint32_t k = 0; k < candidates.count; k += part_lanes) {
        const ShapeLanes shape =
            shape_of<of_a>(gather_corners(search.positions, search.motions, candidates, k));
        const Lanes within = hn::IfThenElse(is_at_border<of_a>(shape.weights),
                                            set(reach.mean * search.of_borders), set(reach.mean));
        auto listed = hn::And(hn::Lt(shape.swept_gap, within), hn::FirstN(Tag(), candidates.count - k));
        // Features that are within reach at the start have boxes that overlap.
        const auto unsure = hn::AndNot(hn::Lt(shape.gap, set(0.999f * reach.mean)), listed);
        if (!hn::AllFalse(Tag(), unsure))
            listed = hn::And(listed, boxes_overlap<of_a>(search, reach, candidates, k));
        for (std::uint32_t rest = bits_of(listed); rest != 0; rest &= rest - 1) {
            const auto i = k + static_cast<std::uint32_t>(std::countr_zero(rest));
            const auto& c = candidates.corners;
            found.add({{c[0][i], c[1][i], c[2][i], c[3][i]}});
        }
    }
    candidates.count = 0;
}

/// A feature's hits among successive other features: those whose boxes may overlap its own. No branch depends
/// on the boxes: it could not be predicted.
struct BoxHits {
    struct Hit {
        std::uint8_t a, b;    ///< the feature, the first of the others
        std::uint16_t lanes;  ///< a bit for each of the others
    };
    static constexpr std::uint32_t most = ContactPatch::most_edges;
    static_assert(most >= ContactPatch::most_triangles && most <= 256);

    Hit list[most * (most + group_lanes) / part_lanes];

    /// Fills the list, and returns its length. `is_same`: a and b are one set; each pair is listed once.
    template <class SlotsA, class SlotsB>
    HWY_INLINE std::uint32_t find(const SlotsA& a, const SlotsB& b, bool is_same) {
        std::uint32_t count = 0;
        for (std::uint32_t i = 0; i < a.count; ++i) {
            const CoarseBox box(a, i);
            const std::uint32_t after = is_same ? i + 1 : 0;
            for (std::uint32_t k = after / part_lanes * part_lanes; k < b.count; k += part_lanes) {
                const std::uint32_t lanes =
                    bits_of<IndexTag>(box.may_overlap(b, k)) & ~0u << (std::max(after, k) - k);
                list[count] = {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(k),
                               static_cast<std::uint16_t>(lanes)};
                count += lanes != 0 ? 1 : 0;
            }
        }
        return count;
    }
};

HWY_INLINE IndexMask mask_of(std::uint16_t bits) {
    std::uint8_t bytes[8] = {};
    std::memcpy(bytes, &bits, sizeof bits);
    return hn::LoadMaskBits(IndexTag(), bytes);
}

/// Gathers candidates, and tests them whenever there are many.
struct PairCollector {
    const PairSearch& search;
    FoundPairs& found;
    PairReach reach;  // of the candidates
    Candidates vertex_triangle, edge_edge;
    NearVertices vertices;
    NearTriangles triangles;
    NearEdges edges, other_edges;
    BoxHits hits;

    HWY_INLINE PairCollector(const PairSearch& s, FoundPairs& f) : search(s), found(f) {}

    HWY_INLINE void test_vertex_triangle() {
        if (vertex_triangle.count == 0) return;
        test_candidates<vertex_and_triangle>(search, reach, vertex_triangle, found.vertex_triangle);
        found.update_fill();
    }
    HWY_INLINE void test_edge_edge() {
        if (edge_edge.count == 0) return;
        test_candidates<edge_and_edge>(search, reach, edge_edge, found.edge_edge);
        found.update_fill();
    }
    void test_all() {
        test_vertex_triangle();
        test_edge_edge();
    }

    HWY_INLINE void pair_vertices_with_triangles() {
        if (found.vertex_triangle.has_enough()) return;
        const IndexTag d;
        const std::uint32_t count = hits.find(vertices, triangles, false);
        for (std::uint32_t h = 0; h < count; ++h) {
            const BoxHits::Hit hit = hits.list[h];
            const Indices vertex = set_index(vertices.corners[0][hit.a]);
            Indices corner[3];
            for (std::uint32_t c = 0; c < 3; ++c) corner[c] = hn::Load(d, triangles.corners[c] + hit.b);
            const auto shared = hn::Or(hn::Eq(vertex, corner[0]),
                                       hn::Or(hn::Eq(vertex, corner[1]), hn::Eq(vertex, corner[2])));
            append<vertex_and_triangle>(vertex_triangle, hn::AndNot(shared, mask_of(hit.lanes)),
                                        {vertex, corner[0], corner[1], corner[2]});
            if (HWY_UNLIKELY(vertex_triangle.count >= Candidates::full)) test_vertex_triangle();
        }
    }

    HWY_INLINE void pair_edges(const NearEdges& a, const NearEdges& b, bool is_same) {
        if (found.edge_edge.has_enough()) return;
        const IndexTag d;
        const std::uint32_t count = hits.find(a, b, is_same);
        for (std::uint32_t h = 0; h < count; ++h) {
            const BoxHits::Hit hit = hits.list[h];
            const Indices a0 = set_index(a.corners[0][hit.a]), a1 = set_index(a.corners[1][hit.a]);
            const Indices b0 = hn::Load(d, b.corners[0] + hit.b), b1 = hn::Load(d, b.corners[1] + hit.b);
            const auto shared =
                hn::Or(hn::Or(hn::Eq(a0, b0), hn::Eq(a0, b1)), hn::Or(hn::Eq(a1, b0), hn::Eq(a1, b1)));
            append<edge_and_edge>(edge_edge, hn::AndNot(shared, mask_of(hit.lanes)), {a0, a1, b0, b1});
            if (HWY_UNLIKELY(edge_edge.count >= Candidates::full)) test_edge_edge();
        }
    }

    /// Tests the candidates so far if those that follow, of bodies a and b, have another reach.
    HWY_INLINE void look_for(const SearchedBody& a, const SearchedBody& b) {
        const PairReach next(a, b);
        if (next == reach) return;
        test_all();
        reach = next;
    }

    HWY_INLINE void visit(const SearchedPatch& a, const SearchedPatch& b, bool is_same) {
        if (found.vertex_triangle.has_enough() && found.edge_edge.has_enough()) return;
        const FeatureBoxes& boxes = *search.boxes;
        const CoarsePlaces places(a.box, b.box);
        look_for(a.body, b.body);
        a.select(boxes, b.box, places, vertices);
        if (vertices.count > 0) {
            b.select(boxes, a.box, places, triangles);
            pair_vertices_with_triangles();
        }
        a.select(boxes, b.box, places, edges);
        if (edges.count > 0) {
            if (!is_same) b.select(boxes, a.box, places, other_edges);
            pair_edges(edges, is_same ? edges : other_edges, is_same);
        }
        if (is_same) return;
        look_for(b.body, a.body);
        b.select(boxes, a.box, places, vertices);
        if (vertices.count > 0) {
            a.select(boxes, b.box, places, triangles);
            pair_vertices_with_triangles();
        }
    }

  private:
    /// Appends near pairs. The first `of_a` corners are the same in all lanes.
    template <std::uint32_t of_a>
    HWY_INLINE static void append(Candidates& to, IndexMask near, const Indices (&corners)[4]) {
        const IndexTag d;
        const Kept kept(near);
        for (std::uint32_t c = 0; c < 4; ++c)
            hn::StoreU(c < of_a ? corners[c] : kept.of(corners[c]), d, to.corners[c] + to.count);
        to.count += kept.count();
    }
};

void find(const PairSearch& search, std::uint32_t block, FoundPairs& found) {
    found.update_fill();  // what other blocks have found may be enough
    PairCollector collector(search, found);
    for_each_near_patch(search, block,
                        [&](const SearchedPatch& a, const SearchedPatch& b, bool is_same)
                            HWY_ATTR { collector.visit(a, b, is_same); });
    collector.test_all();
}

/// Takes as many pairs as a register has lanes, from `first` on.
HWY_INLINE Candidates batch_of(std::span<const FeaturePair> pairs, std::uint32_t first) {
    Candidates batch;
    batch.count = std::min(part_lanes, static_cast<std::uint32_t>(pairs.size()) - first);
    for (std::uint32_t i = 0; i < batch.count; ++i)
        for (std::uint32_t c = 0; c < 4; ++c) batch.corners[c][i] = pairs[first + i].corners[c];
    pad(batch);
    return batch;
}

HWY_INLINE void store_shapes(const ShapeLanes& lanes, std::uint32_t count, PairShape* to) {
    alignas(64) Vec4 weights[group_lanes], normals[group_lanes];
    store_rows(xyz(lanes.weights), lanes.weights.w, weights);
    store_rows(lanes.normal, lanes.gap, normals);
    for (std::uint32_t i = 0; i < count; ++i) to[i] = {weights[i], normals[i]};
}

template <std::uint32_t of_a>
HWY_INLINE void shape(const Vec4* positions, std::span<const FeaturePair> pairs, PairShape* shapes) {
    for (std::uint32_t k = 0; k < pairs.size(); k += part_lanes) {
        const Candidates batch = batch_of(pairs, k);
        store_shapes(shape_of<of_a>(gather_corners(positions, nullptr, batch, 0)), batch.count, shapes + k);
    }
}

template <std::uint32_t of_a>
HWY_INLINE void shape_moving(const Vec4* positions, const Vec4* motions, std::span<const FeaturePair> pairs,
                             PairShape* shapes) {
    for (std::uint32_t k = 0; k < pairs.size(); k += part_lanes) {
        const Candidates batch = batch_of(pairs, k);
        PairShape* const of_batch = shapes + k;
        if (std::none_of(of_batch, of_batch + batch.count,
                         [](const PairShape& shape) { return shape.is_at_border(); }))
            continue;
        const auto of = [&](std::uint32_t i) { return std::min(i, batch.count - 1); };
        const Lanes4 weights = lanes4_of(rows_from(
            [&](std::uint32_t i) HWY_ATTR { return hn::Load(RowTag(), &of_batch[of(i)].weights.x); }));
        const Lanes4 normals = lanes4_of(rows_from(
            [&](std::uint32_t i) HWY_ATTR { return hn::Load(RowTag(), &of_batch[of(i)].normal.x); }));
        const ShapeLanes at_start{weights, xyz(normals), normals.w, set(0)};
        store_shapes(shape_over_motion<of_a>(gather_corners(positions, motions, batch, 0), at_start),
                     batch.count, of_batch);
    }
}

void shapes(const Vec4* positions, bool vertex_triangle, std::span<const FeaturePair> pairs, PairShape* to) {
    vertex_triangle ? shape<vertex_and_triangle>(positions, pairs, to)
                    : shape<edge_and_edge>(positions, pairs, to);
}

void moving_shapes(const Vec4* positions, const Vec4* motions, bool vertex_triangle,
                   std::span<const FeaturePair> pairs, PairShape* to) {
    vertex_triangle ? shape_moving<vertex_and_triangle>(positions, motions, pairs, to)
                    : shape_moving<edge_and_edge>(positions, motions, pairs, to);
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace weft {

HWY_EXPORT(find);
HWY_EXPORT(shapes);
HWY_EXPORT(moving_shapes);

void find_pairs(const PairSearch& search, std::uint32_t block, FoundPairs& found) {
    HWY_DYNAMIC_DISPATCH(find)(search, block, found);
}

void shape_pairs(const Vec4* positions, bool vertex_triangle, std::span<const FeaturePair> pairs,
                 PairShape* to) {
    HWY_DYNAMIC_DISPATCH(shapes)(positions, vertex_triangle, pairs, to);
}

void shape_moving_pairs(const Vec4* positions, const Vec4* motions, bool vertex_triangle,
                        std::span<const FeaturePair> pairs, PairShape* shapes) {
    HWY_DYNAMIC_DISPATCH(moving_shapes)(positions, motions, vertex_triangle, pairs, shapes);
}

}  // namespace weft
#endif
