// Boxes of patches and features over their motion.

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/contact/pairs/pair_kernels.h"
#include "engine/platform.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/contact/pairs/box_kernels.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "collision/contact/pairs/near_slots-inl.h"
#include "collision/geometry/closest-inl.h"

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

/// Positions and motions of a body's particles.
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

/// Boxes around features over their motion, and around the motions; whether all corners are finite.
struct Placed {
    BoxLanes box, motion;
    hn::Mask<Tag> finite;
};

/// The boxes of the features in the slots from `slot` on.
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
    for (; k % 16 != 0; k += part_lanes)  // padding: whole groups are read
        store_boxes(nowhere(), groups[(span.first + k) / 16], k % 16);
}

/// The boxes around all corners of a patch.
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

/// The sides of triangles from their first corner, or the changes of these.
struct SideLanes {
    Lanes3 a, b;

    HWY_INLINE SideLanes(const Vec4* rows, const FeatureSlots<3>& slots, std::uint32_t slot) {
        const Lanes3 first = gather_rows(rows, &slots.corners[0][slot]);
        a = gather_rows(rows, &slots.corners[1][slot]) - first;
        b = gather_rows(rows, &slots.corners[2][slot]) - first;
    }
};

/// Sums of six values over slots, in an order that does not depend on a register's number of lanes.
class SumOfSlots {
  public:
    HWY_INLINE SumOfSlots() {
        for (auto& of_value : lanes_)
            for (Lanes& sum : of_value) sum = set(0);
    }
    HWY_INLINE void add(std::size_t i, std::uint32_t slot, Lanes value) {
        Lanes& sum = lanes_[i][slot % 16 / part_lanes];
        sum = hn::Add(sum, value);
    }
    [[nodiscard]] HWY_INLINE ChartFrame total() const {
        ChartFrame sums{};
        for (std::size_t i = 0; i < 6; ++i) {
            alignas(64) float of_slots[16];
            for (std::uint32_t k = 0; k < 16; k += part_lanes)
                hn::Store(lanes_[i][k / part_lanes], Tag(), of_slots + k);
            for (const float value : of_slots) sums[i] += value;
        }
        return sums;
    }

  private:
    Lanes lanes_[6][16 / part_lanes];
};

/// Fills the gradients of a patch's triangles, and returns their sum.
HWY_INLINE ChartFrame place_gradients(const Moving& moving, const ContactMesh& mesh, const SlotSpan& span,
                                      TriangleGradients* groups) {
    const Tag d;
    constexpr float most2 = 400;  // squared norm beyond which rounding counts
    SumOfSlots sums;
    for (std::uint32_t k = 0; k < span.count; k += part_lanes) {
        const std::uint32_t slot = span.first + k;
        TriangleGradients& group = groups[slot / 16];
        const auto used = hn::FirstN(d, span.count - k);
        const auto add = [&](std::size_t i, Lanes value)
                             HWY_ATTR { sums.add(i, slot, hn::IfThenElseZero(used, value)); };
        const auto store = [&](const Lanes3& a, const Lanes3& b, float(&to)[6][16]) HWY_ATTR {
            const auto of = [&](std::size_t i)
                                HWY_ATTR { return load_lanes(&mesh.flat_rest().inverse(i)[slot]); };
            const Lanes3 u = mul_add(of(0), a, of(2) * b), v = mul_add(of(1), a, of(3) * b);
            const auto known = hn::Lt(hn::Add(dot(u, u), dot(v, v)), set(most2));
            const Lanes values[6] = {u.x, u.y, u.z, v.x, v.y, v.z};
            for (std::size_t i = 0; i < 6; ++i) {
                const Lanes value =
                    hn::IfThenElse(known, values[i], set(std::numeric_limits<float>::quiet_NaN()));
                hn::Store(value, d, to[i] + slot % 16);
                add(i, value);
            }
        };
        const SideLanes sides(moving.positions, mesh.triangle_slots(), slot);
        store(sides.a, sides.b, group.start);
        if (moving.motions == nullptr) continue;
        const SideLanes changes(moving.motions, mesh.triangle_slots(), slot);
        store(sides.a + changes.a, sides.b + changes.b, group.end);
    }
    return sums.total();
}

/// Whether R w . F w is greater than half of `twice_least` for every unit vector w, for all these triangles.
/// (ru, rv) is R.
HWY_INLINE bool keep_apart(const float (&gradients)[6][16], std::uint32_t triangles, const Lanes3& ru,
                           const Lanes3& rv, Lanes twice_least) {
    const Tag d;
    for (std::uint32_t k = 0; k < 16; k += part_lanes) {
        const std::uint32_t part = triangles >> k & ((1u << part_lanes) - 1);
        if (part == 0) continue;
        const std::uint8_t bits[8] = {static_cast<std::uint8_t>(part), static_cast<std::uint8_t>(part >> 8)};
        const auto load = [&](std::size_t i) HWY_ATTR { return load_lanes(gradients[i] + k); };
        const Lanes3 u{load(0), load(1), load(2)}, v{load(3), load(4), load(5)};
        const Lanes uu = dot(ru, u), vv = dot(rv, v), shear = hn::Add(dot(ru, v), dot(rv, u));
        const Lanes stretch = hn::Sub(uu, vv), more = hn::Sub(hn::Add(uu, vv), twice_least);
        const Lanes differs2 = hn::MulAdd(stretch, stretch, hn::Mul(shear, shear));
        const auto apart = hn::And(hn::Gt(more, set(0)), hn::Gt(hn::Mul(more, more), differs2));
        if (!hn::AllFalse(d, hn::AndNot(apart, hn::LoadMaskBits(d, bits)))) return false;
    }
    return true;
}

/// Whether no features of two neighbours that share no vertex come within reach.
HWY_INLINE bool are_calm(const PairSearch& search, const SearchedBody& body, const PatchNeighbours& pair,
                         const PatchStrain& a, const PatchStrain& b, const TriangleGradients* gradients) {
    // The factors are margins for rounding, for a border that is not quite convex, and for triangles that are
    // left out because they cover next to nothing.
    const float reach = body.reach + (search.together ? 0 : a.spread_with(b));
    const float enough = 1.001f * reach / (0.97f * pair.height);
    if (!(enough < 1)) return false;
    ChartFrame sum = a.sum;
    for (std::size_t i = 0; i < 6; ++i) sum[i] += b.sum[i];
    const ChartFrame frame = nearest_frame(sum);
    if (!(frame[0] < infinity)) return false;
    const Lanes3 ru = set_point({frame[0], frame[1], frame[2]}),
                 rv = set_point({frame[3], frame[4], frame[5]});
    const bool moves = search.together && search.motions != nullptr;
    for (const TriangleGroup& group : body.mesh->flat_rest().cover(pair)) {
        const TriangleGradients& of = gradients[group.number];
        if (!keep_apart(of.start, group.triangles, ru, rv, set(2 * enough)) ||
            (moves && !keep_apart(of.end, group.triangles, ru, rv, set(2 * enough))))
            return false;
    }
    return true;
}

HWY_INLINE Moving moving_of(const PairSearch& search, const SearchedBody& body) {
    return {search.positions + body.first, search.motions == nullptr ? nullptr : search.motions + body.first,
            set(half_reach_of(body))};
}

/// Calls visit(k, patch, body, moving) for the patches of a block.
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
                       const Placed all = place_corners(moving, *body.mesh, patch.corners);
                       set_box(boxes.patches[block], k, hull_of_lanes(all.box));
                       if (body.mesh->flat_rest().is_empty()) return;
                       const Bounds m = hull_of_lanes(all.motion);
                       PatchStrain& strain = boxes.strains[block * PatchBlock::most + k];
                       strain.least_motion = {m.lower.x, m.lower.y, m.lower.z};
                       strain.most_motion = {m.upper.x, m.upper.y, m.upper.z};
                   });
    // Clears the boxes behind the last: another search's block may have had more patches.
    for (std::uint32_t k = search.blocks[block].patch_count; k < PatchBlock::most; ++k)
        set_box(boxes.patches[block], k, no_box);
    return hull_of(boxes.patches[block]);
}

/// Calls visit(body, pair, known, p, was_calm) for the neighbours that a search tests, of a block's patches p
/// and those not before them. Others stay calm, or become looked_at.
template <class Visit>
HWY_INLINE void for_each_asked(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes,
                               const Visit& visit) {
    const PatchBlock& patches = search.blocks[block];
    const SearchedBody& body = search.bodies[patches.body];
    const FlatRest& rest = body.mesh->flat_rest();
    if (rest.is_empty()) return;
    const auto is_marked = [&](const std::uint16_t* marked, std::uint32_t p) {
        return (marked[body.first_block + p / PatchBlock::most] >> p % PatchBlock::most & 1) != 0;
    };
    for (std::uint32_t p = patches.first_patch; p < patches.first_patch + patches.patch_count; ++p) {
        for (std::uint32_t n = rest.first_of(p + 1); n-- > rest.first_of(p);) {
            const PatchNeighbours& pair = rest.neighbours()[n];
            Neighbours& known = boxes.neighbours[body.first_neighbours + n];
            const bool was_calm = search.only != nullptr && known == Neighbours::calm;
            const std::uint16_t* const marked = was_calm ? search.strayed : search.only;
            if (marked == nullptr || is_marked(marked, p) || is_marked(marked, pair.other))
                visit(body, pair, known, p, was_calm);
            else if (!was_calm)
                known = Neighbours::looked_at;
        }
    }
}

void want_asked(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    for_each_asked(
        search, block, boxes,
        [&](const SearchedBody& body, const PatchNeighbours& pair, Neighbours, std::uint32_t, bool) {
            for (const TriangleGroup& group : body.mesh->flat_rest().cover(pair))
                store_relaxed(boxes.wanted_gradients[body.first_gradients + group.number], 1);
        });
}

void place_strains(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    for_each_patch(
        search, block,
        [&](std::uint32_t k, const ContactPatch& patch, const SearchedBody& body, const Moving& moving)
            HWY_ATTR {
                if (body.mesh->flat_rest().is_empty()) return;
                const auto is_wanted = [&] {
                    const std::span<const std::uint8_t> wanted = boxes.wanted_gradients.span().subspan(
                        body.first_gradients + patch.triangles.first / 16, (patch.triangles.count + 15) / 16);
                    return std::ranges::find(wanted, 1) != wanted.end();
                };
                if (search.only == nullptr || is_wanted())
                    boxes.strains[block * PatchBlock::most + k].sum = place_gradients(
                        moving, *body.mesh, patch.triangles, &boxes.gradients[body.first_gradients]);
            });
}

void find_known(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    std::uint32_t calm = ~0u;  // the last patch that has a calm neighbour
    for_each_asked(
        search, block, boxes,
        [&](const SearchedBody& body, const PatchNeighbours& pair, Neighbours& known, std::uint32_t p,
            bool was_calm) HWY_ATTR {
            const PatchStrain* const strains =
                &boxes.strains[std::size_t{body.first_block} * PatchBlock::most];
            // A region around a patch and another one contains the patch, whose pair with itself comes last.
            const bool is_calm = (pair.other == p && calm == p) ||
                                 are_calm(search, body, pair, strains[p], strains[pair.other],
                                          &boxes.gradients[body.first_gradients]);
            if (is_calm) calm = p;
            known = is_calm ? Neighbours::calm : was_calm ? Neighbours::opened : Neighbours::looked_at;
        });
}

bool want(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    bool any = false;
    const auto add = [&](const SearchedPatch& patch) {  // by several threads, but always the same value
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
HWY_EXPORT(want_asked);
HWY_EXPORT(place_strains);
HWY_EXPORT(find_known);
HWY_EXPORT(want);
HWY_EXPORT(place_wanted);

Bounds place_patches(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    return HWY_DYNAMIC_DISPATCH(place_around)(search, block, boxes);
}

void want_gradients(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    HWY_DYNAMIC_DISPATCH(want_asked)(search, block, boxes);
}

void place_gradients(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    HWY_DYNAMIC_DISPATCH(place_strains)(search, block, boxes);
}

void find_neighbours(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    HWY_DYNAMIC_DISPATCH(find_known)(search, block, boxes);
}

bool want_features(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    return HWY_DYNAMIC_DISPATCH(want)(search, block, boxes);
}

void place_features(const PairSearch& search, std::uint32_t block, FeatureBoxes& boxes) {
    HWY_DYNAMIC_DISPATCH(place_wanted)(search, block, boxes);
}

}  // namespace weft
#endif
