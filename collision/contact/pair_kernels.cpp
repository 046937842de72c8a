#include "collision/contact/pair_kernels.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/contact/pair_kernels.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "collision/contact/closest-inl.h"
#include "collision/contact/near_slots-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

HWY_INLINE BoxLanes nowhere() {
    const Lanes far = set(infinity), near = set(-infinity);
    return {{far, far, far}, {near, near, near}};
}

HWY_INLINE void store_boxes(const BoxLanes& box, Boxes& boxes, std::uint32_t first) {
    const Tag d;
    hn::Store(box.lower.x, d, boxes.lower_x + first);
    hn::Store(box.lower.y, d, boxes.lower_y + first);
    hn::Store(box.lower.z, d, boxes.lower_z + first);
    hn::Store(box.upper.x, d, boxes.upper_x + first);
    hn::Store(box.upper.y, d, boxes.upper_y + first);
    hn::Store(box.upper.z, d, boxes.upper_z + first);
}

/// Where a body's particles are and go.
struct Moving {
    const Vec4* positions;
    const Vec4* motions;
    Lanes half_reach;
};

/// By half the reach and by more than what rounding takes from a coordinate's sums.
HWY_INLINE BoxLanes grown(const BoxLanes& box, Lanes half_reach) {
    const Lanes rounding = set(0x1p-22f);
    const auto by = [&](Lanes at) HWY_ATTR { return hn::MulAdd(hn::Abs(at), rounding, half_reach); };
    const auto less = [&](Lanes at) HWY_ATTR { return hn::Sub(at, by(at)); };
    const auto more = [&](Lanes at) HWY_ATTR { return hn::Add(at, by(at)); };
    return {{less(box.lower.x), less(box.lower.y), less(box.lower.z)},
            {more(box.upper.x), more(box.upper.y), more(box.upper.z)}};
}

HWY_INLINE BoxLanes everywhere() {
    const BoxLanes none = nowhere();
    return {none.upper, none.lower};
}
template <class Mask>
HWY_INLINE BoxLanes either(Mask mask, const BoxLanes& yes, const BoxLanes& no) {
    return {either(mask, yes.lower, no.lower), either(mask, yes.upper, no.upper)};
}

/// What is around features over their motion, around the motions themselves, and whether all is finite.
struct Placed {
    BoxLanes box, motion;
    hn::Mask<Tag> finite;
};

/// Of the features in the slots from `slot` on.
template <std::uint32_t corner_count>
HWY_INLINE Placed place_lanes(const Moving& moving, const FeatureSlots<corner_count>& slots,
                              std::uint32_t slot) {
    Placed here{nowhere(), nowhere(), hn::FirstN(Tag(), part_lanes)};
    for (std::uint32_t c = 0; c < corner_count; ++c) {
        const std::uint32_t* const particles = &slots.corners[c][slot];
        const Lanes3 x = gather_rows(moving.positions, particles);
        here.box = join(here.box, {x, x});
        here.finite = hn::And(here.finite, is_finite(x));
        if (moving.motions != nullptr) {
            const Lanes3 motion = gather_rows(moving.motions, particles);
            const Lanes3 moved = x + motion;
            here.box = join(here.box, {moved, moved});
            here.motion = join(here.motion, {motion, motion});
            here.finite = hn::And(here.finite, is_finite(moved));
        }
    }
    here.box = grown(here.box, moving.half_reach);
    return here;
}

/// Fills the boxes of a patch's features of one kind.
template <std::uint32_t corner_count>
HWY_INLINE void place(const Moving& moving, const FeatureSlots<corner_count>& slots, const SlotSpan& span,
                      Boxes* groups) {
    std::uint32_t k = 0;
    for (; k < span.count; k += part_lanes) {
        const Placed here = place_lanes(moving, slots, span.first + k);
        const auto used = hn::And(here.finite, hn::FirstN(Tag(), span.count - k));
        store_boxes(either(used, here.box, nowhere()), groups[(span.first + k) / 16], k % 16);
    }
    for (; k % 16 != 0; k += part_lanes)  // whole groups are read
        store_boxes(nowhere(), groups[(span.first + k) / 16], k % 16);
}

/// Around all corners of a patch.
HWY_INLINE Placed place_corners(const Moving& moving, const ContactMesh& mesh, const SlotSpan& span) {
    Placed all{nowhere(), nowhere(), hn::FirstN(Tag(), part_lanes)};
    for (std::uint32_t k = 0; k < span.count; k += part_lanes) {
        const Placed here = place_lanes(moving, mesh.corner_slots(), span.first + k);
        const auto used = hn::FirstN(Tag(), span.count - k);
        const auto finite = hn::And(used, here.finite);
        all.box = join(all.box, either(finite, here.box, nowhere()));
        all.motion = join(all.motion, either(finite, here.motion, either(used, everywhere(), nowhere())));
    }
    return all;
}

/// What is around the gradients of a patch's triangles: of x, y and z along an axis of the chart.
struct Gradients {
    BoxLanes along_u, along_v;
};

HWY_INLINE Gradients gradients_of(const Moving& moving, const ContactMesh& mesh, const SlotSpan& span) {
    Gradients all{nowhere(), nowhere()};
    const auto& corners = mesh.triangle_slots().corners;
    for (std::uint32_t k = 0; k < span.count; k += part_lanes) {
        const std::uint32_t slot = span.first + k;
        const Lanes3 x = gather_rows(moving.positions, &corners[0][slot]);
        const Lanes3 a = gather_rows(moving.positions, &corners[1][slot]) - x;
        const Lanes3 b = gather_rows(moving.positions, &corners[2][slot]) - x;
        const auto inverse = [&](std::size_t i)
                                 HWY_ATTR { return load_lanes(&mesh.flat_rest().inverse(i)[slot]); };
        const Lanes3 u = mul_add(inverse(0), a, inverse(2) * b), v = mul_add(inverse(1), a, inverse(3) * b);
        const auto used = hn::FirstN(Tag(), span.count - k);
        const BoxLanes otherwise = either(used, everywhere(), nowhere());
        const auto finite = hn::And(used, hn::And(is_finite(u), is_finite(v)));
        all.along_u = join(all.along_u, either(finite, {u, u}, otherwise));
        all.along_v = join(all.along_v, either(finite, {v, v}, otherwise));
    }
    return all;
}

PatchStrain strain_of(const Gradients& gradients, const BoxLanes& motion) {
    const Bounds u = hull_of_lanes(gradients.along_u), v = hull_of_lanes(gradients.along_v);
    const Bounds m = hull_of_lanes(motion);
    return {{u.lower.x, u.lower.y, u.lower.z, v.lower.x, v.lower.y, v.lower.z},
            {u.upper.x, u.upper.y, u.upper.z, v.upper.x, v.upper.y, v.upper.z},
            {m.lower.x, m.lower.y, m.lower.z},
            {m.upper.x, m.upper.y, m.upper.z}};
}

HWY_INLINE Moving moving_of(const PairSearch& search, const SearchedBody& body) {
    return {search.positions + body.first, search.motions == nullptr ? nullptr : search.motions + body.first,
            set(0.5f * body.reach * (1 + 1e-6f))};
}

Bounds place_around(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    const PatchBlock& patches = search.blocks[block];
    const SearchedBody& body = search.bodies[patches.body];
    const ContactMesh& mesh = *body.mesh;
    const Moving moving = moving_of(search, body);
    for (std::uint32_t k = 0; k < patches.patch_count; ++k) {
        const ContactPatch& patch = mesh.patches()[patches.first_patch + k];
        const Placed all = place_corners(moving, mesh, patch.corners);
        set_box(boxes.patches[block], k, hull_of_lanes(all.box));
        boxes.wanted[block * PatchBlock::most + k] = 0;
        if (!mesh.flat_rest().is_empty())
            boxes.strains[block * PatchBlock::most + k] =
                strain_of(gradients_of(moving, mesh, patch.triangles), all.motion);
    }
    return hull_of(boxes.patches[block]);
}

bool want(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    bool any = false;
    const auto add = [&](const SearchedPatch& patch) {  // by any thread, but always the same
        std::uint8_t& wanted = boxes.wanted[patch.body.first_block * PatchBlock::most + patch.number];
        std::atomic_ref<std::uint8_t>(wanted).store(1, std::memory_order_relaxed);
    };
    for_each_near_patch(search, block, [&](const SearchedPatch& a, const SearchedPatch& b, bool) HWY_ATTR {
        add(a);
        add(b);
        any = true;
    });
    return any;
}

void place_wanted(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    const PatchBlock& patches = search.blocks[block];
    const SearchedBody& body = search.bodies[patches.body];
    const ContactMesh& mesh = *body.mesh;
    const Moving moving = moving_of(search, body);
    for (std::uint32_t k = 0; k < patches.patch_count; ++k) {
        if (boxes.wanted[block * PatchBlock::most + k] == 0) continue;
        const ContactPatch& patch = mesh.patches()[patches.first_patch + k];
        place(moving, mesh.vertex_slots(), patch.vertices, &boxes.vertices[body.first_vertex_group]);
        place(moving, mesh.triangle_slots(), patch.triangles, &boxes.triangles[body.first_triangle_group]);
        place(moving, mesh.edge_slots(), patch.edges, &boxes.edges[body.first_edge_group]);
    }
}

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

/// Passes on, of the candidates, those that come within reach.
template <std::uint32_t of_a>
HWY_NOINLINE void test_candidates(const PairSearch& search, float reach, Candidates& candidates,
                                  Found<FeaturePair>& found) {
    if (candidates.count == 0) return;
    pad(candidates);
    for (std::uint32_t k = 0; k < candidates.count; k += part_lanes) {
        const ShapeLanes shape =
            shape_of<of_a>(gather_corners(search.positions, search.motions, candidates, k));
        const auto listed =
            hn::And(hn::Lt(shape.swept_gap, set(reach)), hn::FirstN(Tag(), candidates.count - k));
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

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace weft {

HWY_EXPORT(place_around);
HWY_EXPORT(want);
HWY_EXPORT(place_wanted);
HWY_EXPORT(find);
HWY_EXPORT(shapes);

Bounds place_patches(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    return HWY_DYNAMIC_DISPATCH(place_around)(search, block, boxes);
}

bool want_features(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    return HWY_DYNAMIC_DISPATCH(want)(search, block, boxes);
}

void place_features(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    HWY_DYNAMIC_DISPATCH(place_wanted)(search, block, boxes);
}

void find_pairs(const PairSearch& search, std::uint32_t block, FoundPairs& found) {
    HWY_DYNAMIC_DISPATCH(find)(search, block, found);
}

void shape_pairs(const Vec4* positions, bool vertex_triangle, std::span<const FeaturePair> pairs,
                 PairShape* to) {
    HWY_DYNAMIC_DISPATCH(shapes)(positions, vertex_triangle, pairs, to);
}

}  // namespace weft
#endif
