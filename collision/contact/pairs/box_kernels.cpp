// Boxes of patches and features over their motion.

#include <cmath>
#include <limits>

#include "collision/contact/pairs/pair_kernels.h"
#include "engine/platform.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/contact/pairs/box_kernels.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "collision/contact/pairs/closest-inl.h"
#include "collision/contact/pairs/near_slots-inl.h"

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

/// The gradients of a patch's triangles: of x, y and z along an axis of the chart.
struct Gradients {
    alignas(64) float of[6][ContactPatch::most_triangles];

    [[nodiscard]] HWY_INLINE Lanes3 along(std::uint32_t axis, std::uint32_t k) const {
        const auto& rows = &of[3 * axis];
        return {load_lanes(rows[0] + k), load_lanes(rows[1] + k), load_lanes(rows[2] + k)};
    }
};

/// Returns their sum.
HWY_INLINE ChartFrame find_gradients(const Moving& moving, const ContactMesh& mesh, const SlotSpan& span,
                                     Gradients& gradients) {
    const Tag d;
    Lanes sums[6];
    for (Lanes& sum : sums) sum = set(0);
    const auto& corners = mesh.triangle_slots().corners;
    for (std::uint32_t k = 0; k < span.count; k += part_lanes) {
        const std::uint32_t slot = span.first + k;
        const Lanes3 x = gather_rows(moving.positions, &corners[0][slot]);
        const Lanes3 a = gather_rows(moving.positions, &corners[1][slot]) - x;
        const Lanes3 b = gather_rows(moving.positions, &corners[2][slot]) - x;
        const auto inverse = [&](std::size_t i)
                                 HWY_ATTR { return load_lanes(&mesh.flat_rest().inverse(i)[slot]); };
        const Lanes3 u = mul_add(inverse(0), a, inverse(2) * b), v = mul_add(inverse(1), a, inverse(3) * b);
        const Lanes values[6] = {u.x, u.y, u.z, v.x, v.y, v.z};
        const auto used = hn::FirstN(d, span.count - k);
        for (std::size_t i = 0; i < 6; ++i) {
            hn::Store(values[i], d, gradients.of[i] + k);
            sums[i] = hn::Add(sums[i], hn::IfThenElseZero(used, values[i]));
        }
    }
    ChartFrame sum;
    for (std::size_t i = 0; i < 6; ++i) sum[i] = hn::GetLane(hn::SumOfLanes(d, sums[i]));
    return sum;
}

/// What the header of FlatRest knows of a patch.
HWY_INLINE PatchStrain strain_of(const Moving& moving, const ContactMesh& mesh, const SlotSpan& span,
                                 const BoxLanes& motion) {
    const Tag d;
    Gradients gradients;
    const ChartFrame frame = nearest_frame(find_gradients(moving, mesh, span, gradients));
    const Bounds m = hull_of_lanes(motion);
    PatchStrain strain{
        frame, -1, infinity, {m.lower.x, m.lower.y, m.lower.z}, {m.upper.x, m.upper.y, m.upper.z}};
    if (!(frame[0] < infinity)) return strain;

    const Lanes3 qu = set_point({frame[0], frame[1], frame[2]}),
                 qv = set_point({frame[3], frame[4], frame[5]});
    const Lanes3 normal = cross(qu, qv);
    Lanes least = set(infinity), most = set(0);
    bool is_known = true;
    for (std::uint32_t k = 0; k < span.count; k += part_lanes) {
        const Lanes3 u = gradients.along(0, k), v = gradients.along(1, k);
        const Lanes half = set(0.5f), uu = dot(qu, u), uv = dot(qu, v), vu = dot(qv, u), vv = dot(qv, v);
        const Lanes stretch = hn::Mul(half, hn::Sub(uu, vv)), shear = hn::Mul(half, hn::Add(uv, vu));
        const Lanes differs = hn::Sqrt(hn::MulAdd(stretch, stretch, hn::Mul(shear, shear)));
        const Lanes along = hn::Sub(hn::Mul(half, hn::Add(uu, vv)), differs);
        const Lanes aside = hn::Add(differs, hn::Abs(hn::Mul(half, hn::Sub(vu, uv))));
        const Lanes out_u = dot(normal, u), out_v = dot(normal, v);
        const Lanes across2 = hn::MulAdd(aside, aside, hn::MulAdd(out_u, out_u, hn::Mul(out_v, out_v)));
        const auto used = hn::FirstN(d, span.count - k);
        const Lanes size = hn::Add(dot(u, u), dot(v, v));
        is_known &= hn::AllTrue(d, hn::Or(hn::Not(used), hn::Lt(size, set(400))));
        least = hn::IfThenElse(used, hn::Min(least, along), least);
        most = hn::IfThenElse(used, hn::Max(most, across2), most);
    }
    if (!is_known) return strain;
    strain.along = hn::GetLane(hn::MinOfLanes(d, least));
    strain.across = std::sqrt(hn::GetLane(hn::MaxOfLanes(d, most)));
    return strain;
}

HWY_INLINE Moving moving_of(const PairSearch& search, const SearchedBody& body) {
    return {search.positions + body.first, search.motions == nullptr ? nullptr : search.motions + body.first,
            set(half_reach_of(body))};
}

/// visit(k, patch, body, moving) for the patches of a block.
template <class Visit>
HWY_INLINE void for_each_patch(const PairSearch& search, std::uint32_t block, const Visit& visit) {
    const PatchBlock& patches = search.blocks[block];
    const SearchedBody& body = search.bodies[patches.body];
    const Moving moving = moving_of(search, body);
    for (std::uint32_t k = 0; k < patches.patch_count; ++k)
        visit(k, body.mesh->patches()[patches.first_patch + k], body, moving);
}

Bounds place_around(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    for_each_patch(search, block,
                   [&](std::uint32_t k, const ContactPatch& patch, const SearchedBody& body,
                       const Moving& moving) HWY_ATTR {
                       const ContactMesh& mesh = *body.mesh;
                       const Placed all = place_corners(moving, mesh, patch.corners);
                       set_box(boxes.patches[block], k, hull_of_lanes(all.box));
                       boxes.wanted[block * PatchBlock::most + k] = 0;
                       if (!mesh.flat_rest().is_empty())
                           boxes.strains[block * PatchBlock::most + k] =
                               strain_of(moving, mesh, patch.triangles, all.motion);
                   });
    // Another search's block may have had more patches.
    for (std::uint32_t k = search.blocks[block].patch_count; k < PatchBlock::most; ++k)
        set_box(boxes.patches[block], k, no_box);
    return hull_of(boxes.patches[block]);
}

void find_calm(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    const PatchBlock& patches = search.blocks[block];
    const SearchedBody& body = search.bodies[patches.body];
    const FlatRest& rest = body.mesh->flat_rest();
    for (std::uint32_t k = 0; k < patches.patch_count; ++k)
        rest.find_calm(patches.first_patch + k, body.reach,
                       &boxes.strains[std::size_t{body.first_block} * PatchBlock::most],
                       boxes.calm.span().subspan(body.first_neighbours, rest.pairs()));
}

bool want(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    find_calm(search, block, boxes);
    bool any = false;
    const auto add = [&](const SearchedPatch& patch) {  // by any thread, but always the same
        std::uint8_t& wanted = boxes.wanted[patch.body.first_block * PatchBlock::most + patch.number];
        store_relaxed(wanted, 1);
    };
    for_each_near_patch(search, block, [&](const SearchedPatch& a, const SearchedPatch& b, bool) HWY_ATTR {
        add(a);
        add(b);
        any = true;
    });
    return any;
}

void place_wanted(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    for_each_patch(
        search, block,
        [&](std::uint32_t k, const ContactPatch& patch, const SearchedBody& body, const Moving& moving)
            HWY_ATTR {
                if (boxes.wanted[block * PatchBlock::most + k] == 0) return;
                const ContactMesh& mesh = *body.mesh;
                place(moving, mesh.vertex_slots(), patch.vertices, &boxes.vertices[body.first_vertex_group]);
                place(moving, mesh.triangle_slots(), patch.triangles,
                      &boxes.triangles[body.first_triangle_group]);
                place(moving, mesh.edge_slots(), patch.edges, &boxes.edges[body.first_edge_group]);
            });
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace weft {

HWY_EXPORT(place_around);
HWY_EXPORT(want);
HWY_EXPORT(place_wanted);

Bounds place_patches(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    return HWY_DYNAMIC_DISPATCH(place_around)(search, block, boxes);
}

bool want_features(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    return HWY_DYNAMIC_DISPATCH(want)(search, block, boxes);
}

void place_features(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    HWY_DYNAMIC_DISPATCH(place_wanted)(search, block, boxes);
}

}  // namespace weft
#endif
