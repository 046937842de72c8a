#include "collision/contact/pair_kernels.h"

#include <algorithm>
#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/contact/pair_kernels.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "collision/contact/closest-inl.h"
#include "collision/contact/near_slots-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

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

/// Lanes past the end repeat the first candidate.
HWY_INLINE void pad(Candidates& candidates) {
    for (auto& corner : candidates.corners)
        for (std::uint32_t k = 0; k < part_lanes; ++k) corner[candidates.count + k] = corner[0];
}

/// PairShape::is_at_border.
template <std::uint32_t of_a>
HWY_INLINE hn::Mask<Tag> is_at_border(const Lanes4& w) {
    const auto in_triangle = hn::Or(hn::Eq(w.y, set(0)), hn::Or(hn::Eq(w.z, set(0)), hn::Eq(w.w, set(0))));
    return of_a == vertex_and_triangle ? in_triangle : hn::Or(in_triangle, hn::Eq(w.x, set(0)));
}

/// Passes on, of the candidates, those that come within reach.
template <std::uint32_t of_a>
HWY_NOINLINE void test_candidates(const PairSearch& search, float reach, Candidates& candidates,
                                  Found<FeaturePair>& found) {
    if (found.has_enough()) candidates.count = 0;
    if (candidates.count == 0) return;
    pad(candidates);
    for (std::uint32_t k = 0; k < candidates.count; k += part_lanes) {
        const ShapeLanes shape =
            shape_of<of_a>(gather_corners(search.positions, search.motions, candidates, k));
        const Lanes within =
            hn::IfThenElse(is_at_border<of_a>(shape.weights), set(reach * search.of_borders), set(reach));
        const auto listed = hn::And(hn::Lt(shape.swept_gap, within), hn::FirstN(Tag(), candidates.count - k));
        for (std::uint32_t rest = bits_of(listed); rest != 0; rest &= rest - 1) {
            const auto i = k + static_cast<std::uint32_t>(std::countr_zero(rest));
            const auto& c = candidates.corners;
            found.add({{c[0][i], c[1][i], c[2][i], c[3][i]}});
        }
    }
    candidates.count = 0;
}

/// Gathers candidates, and tests them whenever there are many.
struct PairCollector {
    const PairSearch& search;
    FoundPairs& found;
    float reach = 0;  // of the candidates
    Candidates vertex_triangle, edge_edge;
    NearVertices vertices;
    NearTriangles triangles;
    NearEdges edges, other_edges;

    HWY_INLINE PairCollector(const PairSearch& s, FoundPairs& f) : search(s), found(f) {}

    void test_all() {
        test_candidates<vertex_and_triangle>(search, reach, vertex_triangle, found.vertex_triangle);
        test_candidates<edge_and_edge>(search, reach, edge_edge, found.edge_edge);
    }

    HWY_INLINE void pair_vertices_with_triangles() {
        if (found.vertex_triangle.has_enough()) return;
        const IndexTag d;
        for (std::uint32_t i = 0; i < vertices.count; ++i) {
            const BoxLanes box = vertices.box(i);
            const Indices vertex = set_index(vertices.corners[0][i]);
            for (std::uint32_t k = 0; k < triangles.count; k += part_lanes) {
                const auto near_boxes =
                    hn::And(overlap(box, triangles.boxes(k)), hn::FirstN(Tag(), triangles.count - k));
                if (hn::AllFalse(Tag(), near_boxes)) continue;
                Indices corner[3];
                for (std::uint32_t c = 0; c < 3; ++c) corner[c] = hn::Load(d, triangles.corners[c] + k);
                const auto shared = hn::Or(hn::Eq(vertex, corner[0]),
                                           hn::Or(hn::Eq(vertex, corner[1]), hn::Eq(vertex, corner[2])));
                const auto near = hn::AndNot(shared, hn::RebindMask(d, near_boxes));
                append(vertex_triangle, near, vertex, corner[0], corner[1], corner[2]);
            }
            if (HWY_UNLIKELY(vertex_triangle.count >= Candidates::full))
                test_candidates<vertex_and_triangle>(search, reach, vertex_triangle, found.vertex_triangle);
        }
    }

    HWY_INLINE void pair_edges(const NearEdges& a, const NearEdges& b, bool is_same) {
        if (found.edge_edge.has_enough()) return;
        const IndexTag d;
        for (std::uint32_t i = 0; i < a.count; ++i) {
            const BoxLanes box = a.box(i);
            const Indices a0 = set_index(a.corners[0][i]), a1 = set_index(a.corners[1][i]);
            const std::uint32_t after = is_same ? i + 1 : 0;  // of a patch with itself, each pair once
            for (std::uint32_t k = after / part_lanes * part_lanes; k < b.count; k += part_lanes) {
                const auto near_boxes = hn::And(overlap(box, b.boxes(k)), hn::FirstN(Tag(), b.count - k));
                if (hn::AllFalse(Tag(), near_boxes)) continue;
                const Indices b0 = hn::Load(d, b.corners[0] + k), b1 = hn::Load(d, b.corners[1] + k);
                const auto shared =
                    hn::Or(hn::Or(hn::Eq(a0, b0), hn::Eq(a0, b1)), hn::Or(hn::Eq(a1, b0), hn::Eq(a1, b1)));
                const auto before = hn::FirstN(d, std::max(after, k) - k);
                const auto near = hn::AndNot(hn::Or(shared, before), hn::RebindMask(d, near_boxes));
                append(edge_edge, near, a0, a1, b0, b1);
            }
            if (HWY_UNLIKELY(edge_edge.count >= Candidates::full))
                test_candidates<edge_and_edge>(search, reach, edge_edge, found.edge_edge);
        }
    }

    HWY_INLINE void visit(const SearchedPatch& a, const SearchedPatch& b, bool is_same) {
        if (found.vertex_triangle.has_enough() && found.edge_edge.has_enough()) return;
        const float mean = 0.5f * (a.body.reach + b.body.reach);
        if (mean != reach) {
            test_all();
            reach = mean;
        }
        const FeatureBoxes& boxes = *search.boxes;
        a.select(boxes, b.box, vertices);
        if (vertices.count > 0) {
            b.select(boxes, a.box, triangles);
            pair_vertices_with_triangles();
        }
        if (!is_same) {
            b.select(boxes, a.box, vertices);
            if (vertices.count > 0) {
                a.select(boxes, b.box, triangles);
                pair_vertices_with_triangles();
            }
        }
        a.select(boxes, b.box, edges);
        if (edges.count == 0) return;
        if (!is_same) b.select(boxes, a.box, other_edges);
        pair_edges(edges, is_same ? edges : other_edges, is_same);
    }

  private:
    template <class Mask>
    HWY_INLINE static void append(Candidates& to, Mask near, Indices c0, Indices c1, Indices c2, Indices c3) {
        const IndexTag d;
        if (hn::AllFalse(d, near)) return;
        const Kept kept(near);
        hn::StoreU(kept.of(c0), d, to.corners[0] + to.count);
        hn::StoreU(kept.of(c1), d, to.corners[1] + to.count);
        hn::StoreU(kept.of(c2), d, to.corners[2] + to.count);
        hn::StoreU(kept.of(c3), d, to.corners[3] + to.count);
        to.count += kept.count();
    }
};

void find(const PairSearch& search, std::uint32_t block, FoundPairs& found) {
    PairCollector collector(search, found);
    for_each_near_patch(search, block,
                        [&](const SearchedPatch& a, const SearchedPatch& b, bool is_same)
                            HWY_ATTR { collector.visit(a, b, is_same); });
    collector.test_all();
}

template <std::uint32_t of_a>
HWY_INLINE void shape(const Vec4* positions, std::span<const FeaturePair> pairs, PairShape* shapes) {
    Candidates batch;
    alignas(64) Vec4 weights[group_lanes], normals[group_lanes];
    for (std::uint32_t k = 0; k < pairs.size(); k += part_lanes) {
        batch.count = std::min(part_lanes, static_cast<std::uint32_t>(pairs.size()) - k);
        for (std::uint32_t i = 0; i < batch.count; ++i)
            for (std::uint32_t c = 0; c < 4; ++c) batch.corners[c][i] = pairs[k + i].corners[c];
        pad(batch);
        const ShapeLanes lanes = shape_of<of_a>(gather_corners(positions, nullptr, batch, 0));
        store_rows(xyz(lanes.weights), lanes.weights.w, weights);
        store_rows(lanes.normal, lanes.gap, normals);
        for (std::uint32_t i = 0; i < batch.count; ++i) shapes[k + i] = {weights[i], normals[i]};
    }
}

void shapes(const Vec4* positions, bool vertex_triangle, std::span<const FeaturePair> pairs, PairShape* to) {
    vertex_triangle ? shape<vertex_and_triangle>(positions, pairs, to)
                    : shape<edge_and_edge>(positions, pairs, to);
}

/// Some of a list's pairs, by their numbers.
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

/// Around corners over their motion.
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
        narrow.reach + 2 * narrow.longest;  // whatever the motions, with what rounding takes
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

HWY_EXPORT(find);
HWY_EXPORT(shapes);
HWY_EXPORT(narrow);

void find_pairs(const PairSearch& search, std::uint32_t block, FoundPairs& found) {
    HWY_DYNAMIC_DISPATCH(find)(search, block, found);
}

void shape_pairs(const Vec4* positions, bool vertex_triangle, std::span<const FeaturePair> pairs,
                 PairShape* to) {
    HWY_DYNAMIC_DISPATCH(shapes)(positions, vertex_triangle, pairs, to);
}

std::uint32_t narrow_pairs(const PairNarrow& to, bool vertex_triangle, std::span<FeaturePair> pairs,
                           PairShape* shapes) {
    return HWY_DYNAMIC_DISPATCH(narrow)(to, vertex_triangle, pairs, shapes);
}

}  // namespace weft
#endif
