// The features of a patch that are near another patch, in arrays. Included as engine/simd/lanes-inl.h is.

#if defined(WEFT_COLLISION_CONTACT_PAIRS_NEAR_SLOTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_COLLISION_CONTACT_PAIRS_NEAR_SLOTS_INL_H
#undef WEFT_COLLISION_CONTACT_PAIRS_NEAR_SLOTS_INL_H
#else
#define WEFT_COLLISION_CONTACT_PAIRS_NEAR_SLOTS_INL_H
#endif

#include <bit>

#include "collision/contact/pairs/pair_kernels.h"
#include "collision/search/boxes-inl.h"
#include "collision/search/compress-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// Whether the two boxes in a lane have a point in common.
HWY_INLINE hn::Mask<Tag> overlap(const BoxLanes& a, const BoxLanes& b) {
    const auto x = hn::And(hn::Le(a.lower.x, b.upper.x), hn::Le(b.lower.x, a.upper.x));
    const auto y = hn::And(hn::Le(a.lower.y, b.upper.y), hn::Le(b.lower.y, a.upper.y));
    const auto z = hn::And(hn::Le(a.lower.z, b.upper.z), hn::Le(b.lower.z, a.upper.z));
    return hn::And(x, hn::And(y, z));
}

/// One bit for each of sixteen boxes that overlaps `box`.
HWY_INLINE std::uint32_t overlapping(const BoxLanes& box, const Boxes& boxes) {
    std::uint32_t all = 0;
    for (std::uint32_t first = 0; first < 16; first += part_lanes)
        all |= bits_of(overlap(box, load_boxes(boxes, first))) << first;
    return all;
}

/// The box grown by half the reach, and by more than the rounding error of sums at its coordinates.
HWY_INLINE BoxLanes grown(const BoxLanes& box, Lanes half_reach) {
    const Lanes rounding = set(0x1p-22f);
    const auto by = [&](Lanes at) HWY_ATTR { return hn::MulAdd(hn::Abs(at), rounding, half_reach); };
    const auto less = [&](Lanes at) HWY_ATTR { return hn::Sub(at, by(at)); };
    const auto more = [&](Lanes at) HWY_ATTR { return hn::Add(at, by(at)); };
    return {{less(box.lower.x), less(box.lower.y), less(box.lower.z)},
            {more(box.upper.x), more(box.upper.y), more(box.upper.z)}};
}

/// The box of features over their motion, as place_features() computes it; `corners`: lists of particles, one
/// for each of a feature's corners.
template <class Corners>
HWY_INLINE BoxLanes placed_box(const PairSearch& search, const Corners& corners, std::uint32_t begin,
                               std::uint32_t end, std::uint32_t first, float half_reach) {
    const auto box_of_corner = [&](std::uint32_t c) HWY_ATTR {
        const Lanes3 x = gather_rows(search.positions, corners[c] + first);
        if (search.motions == nullptr) return BoxLanes{x, x};
        const Lanes3 moved = x + gather_rows(search.motions, corners[c] + first);
        return join({x, x}, {moved, moved});
    };
    BoxLanes box = box_of_corner(begin);
    for (std::uint32_t c = begin + 1; c < end; ++c) box = join(box, box_of_corner(c));
    return grown(box, set(half_reach));
}

/// Quantised coordinates: places in the intersection of two boxes, from 0 to 255 along each axis, a byte for
/// each. Rounding keeps order: boxes that overlap still do, and so do some that do not.
class CoarsePlaces {
  public:
    HWY_INLINE CoarsePlaces(const BoxLanes& a, const BoxLanes& b) : origin_(maximum(a.lower, b.lower)) {
        const Lanes3 extent = minimum(a.upper, b.upper) - origin_;
        const auto scale = [](Lanes of) HWY_ATTR { return hn::Div(set(255), hn::Max(of, set(1e-30f))); };
        scale_ = {scale(extent.x), scale(extent.y), scale(extent.z)};
    }
    HWY_INLINE Indices of(const Lanes3& point) const {
        const IndexTag d;
        const auto place = [&](Lanes x, Lanes from, Lanes scale) HWY_ATTR {
            const Lanes at = hn::Mul(hn::Sub(x, from), scale);
            const Lanes within = hn::IfThenElseZero(hn::Gt(at, set(0)), hn::Min(at, set(255)));
            return hn::BitCast(d, hn::ConvertTo(hn::RebindToSigned<IndexTag>(), within));
        };
        const Indices x = place(point.x, origin_.x, scale_.x), y = place(point.y, origin_.y, scale_.y),
                      z = place(point.z, origin_.z, scale_.z);
        return hn::Or(x, hn::Or(hn::ShiftLeft<8>(y), hn::ShiftLeft<16>(z)));
    }

  private:
    Lanes3 origin_, scale_;
};

/// Features with their coarse boxes, and their corners numbered through all bodies.
template <std::uint32_t corner_count, std::uint32_t most>
struct NearSlots {
    static constexpr std::uint32_t capacity = most + group_lanes;

    std::uint32_t count = 0;
    alignas(64) std::uint32_t lower[capacity], upper[capacity];
    alignas(64) std::uint32_t corners[corner_count][capacity];

    /// Selects the slots of a patch whose boxes overlap `other`.
    HWY_INLINE void select(const FeatureSlots<corner_count>& slots, const SlotSpan& span, const Boxes* groups,
                           std::uint32_t first_particle, const BoxLanes& other, const CoarsePlaces& places) {
        const IndexTag d;
        count = 0;
        for (std::uint32_t k = 0; k < span.count; k += part_lanes) {
            const BoxLanes here = load_boxes(groups[(span.first + k) / 16], k % 16);
            const auto near = overlap(here, other);
            if (hn::AllFalse(Tag(), near)) continue;
            const Kept kept(hn::RebindMask(d, near));
            hn::StoreU(kept.of(places.of(here.lower)), d, lower + count);
            hn::StoreU(kept.of(places.of(here.upper)), d, upper + count);
            for (std::uint32_t c = 0; c < corner_count; ++c) {
                const Indices corner = hn::Load(d, &slots.corners[c][span.first + k]);
                hn::StoreU(kept.of(hn::Add(corner, set_index(first_particle))), d, corners[c] + count);
            }
            count += kept.count();
        }
        // Padding behind the last slot: boxes that overlap nothing.
        hn::StoreU(set_index(~0u), d, lower + count);
        hn::StoreU(set_index(0), d, upper + count);
    }
};

/// One feature's coarse box, in every lane.
struct CoarseBox {
    Indices lower, upper;

    template <class Slots>
    HWY_INLINE CoarseBox(const Slots& slots, std::uint32_t k)
        : lower(set_index(slots.lower[k])), upper(set_index(slots.upper[k])) {}

    /// The features from `first` on, as many as a register has lanes, that may overlap this one.
    template <class Slots>
    HWY_INLINE IndexMask may_overlap(const Slots& slots, std::uint32_t first) const {
        const IndexTag d;
        const hn::Repartition<std::uint8_t, IndexTag> bytes;
        const auto beyond = [&](Indices from, Indices to) HWY_ATTR {
            return hn::SaturatedSub(hn::BitCast(bytes, from), hn::BitCast(bytes, to));
        };
        const auto apart = hn::Or(beyond(lower, hn::Load(d, slots.upper + first)),
                                  beyond(hn::Load(d, slots.lower + first), upper));
        return hn::Eq(hn::BitCast(d, apart), hn::Zero(d));
    }
};

using NearVertices = NearSlots<1, ContactPatch::most_vertices>;
using NearTriangles = NearSlots<3, ContactPatch::most_triangles>;
using NearEdges = NearSlots<2, ContactPatch::most_edges>;

/// A patch in a search, and its box.
struct SearchedPatch {
    const SearchedBody& body;
    std::uint32_t number;  // within the body
    const ContactPatch& patch;
    BoxLanes box;

    HWY_INLINE SearchedPatch(const PairSearch& search, std::uint32_t block, std::uint32_t k)
        : body(search.bodies[search.blocks[block].body]),
          number(search.blocks[block].first_patch + k),
          patch(body.mesh->patches()[number]),
          box(box_of(search.boxes->patches[block], k)) {}

    HWY_INLINE void select(const FeatureBoxes& boxes, const BoxLanes& other, const CoarsePlaces& places,
                           NearVertices& near) const {
        near.select(body.mesh->vertex_slots(), patch.vertices, &boxes.vertices[body.first_vertex_group],
                    body.first, other, places);
    }
    HWY_INLINE void select(const FeatureBoxes& boxes, const BoxLanes& other, const CoarsePlaces& places,
                           NearTriangles& near) const {
        near.select(body.mesh->triangle_slots(), patch.triangles, &boxes.triangles[body.first_triangle_group],
                    body.first, other, places);
    }
    HWY_INLINE void select(const FeatureBoxes& boxes, const BoxLanes& other, const CoarsePlaces& places,
                           NearEdges& near) const {
        near.select(body.mesh->edge_slots(), patch.edges, &boxes.edges[body.first_edge_group], body.first,
                    other, places);
    }
};

inline bool may_meet(const SearchedBody& a, const SearchedBody& b) {
    return &a == &b ? a.meets_itself : masks_allow(a.layer, a.mask, b.layer, b.mask);
}

/// Whether the search covers two patches, by the results of find_neighbours(). `is_marked`: one of them has
/// its bit in PairSearch::only, or all patches count as marked.
inline bool is_to_be_looked_at(const PairSearch& search, const SearchedPatch& a, const SearchedPatch& b,
                               bool is_marked) {
    const std::uint32_t pair =
        &a.body != &b.body ? FlatRest::none : a.body.mesh->flat_rest().find(a.number, b.number);
    const Neighbours known = pair == FlatRest::none
                                 ? Neighbours::looked_at
                                 : search.boxes->neighbours[a.body.first_neighbours + pair];
    return known == Neighbours::opened || (known == Neighbours::looked_at && is_marked);
}

/// The patches of block `other`, a bit for each, that make a marked pair with patch p of `block`.
inline std::uint32_t marked_beside(const PairSearch& search, std::uint32_t block, std::uint32_t p,
                                   std::uint32_t other) {
    if (search.only == nullptr) return ~0u;
    return (search.only[block] >> p & 1) != 0 ? ~0u : search.only[other];
}

/// Calls visit(patch, other, is_same) for the pairs of patches that the search covers, of a block and those
/// after it, whose boxes overlap and whose bodies meet. A patch makes a pair with itself.
template <class Visit>
HWY_INLINE void for_each_near_patch(const PairSearch& search, std::uint32_t block, const Visit& visit) {
    const FeatureBoxes& boxes = *search.boxes;
    const SearchedBody& body = search.bodies[search.blocks[block].body];
    const BoxLanes block_box = box_of(boxes.blocks[block / 16], block % 16);
    const auto visit_block = [&](std::uint32_t other) HWY_ATTR {
        const SearchedBody& other_body = search.bodies[search.blocks[other].body];
        if (!may_meet(body, other_body)) return;
        const bool may_be_neighbours = &body == &other_body && !body.mesh->flat_rest().is_empty();
        if (!may_be_neighbours && search.only != nullptr && (search.only[block] | search.only[other]) == 0)
            return;
        for (std::uint32_t p = 0; p < search.blocks[block].patch_count; ++p) {
            const SearchedPatch patch(search, block, p);
            std::uint32_t near = overlapping(patch.box, boxes.patches[other]);
            if (other == block) near &= ~0u << p;
            const std::uint32_t marked = marked_beside(search, block, p, other);
            if (!may_be_neighbours) near &= marked;
            for (; near != 0; near &= near - 1) {
                const auto q = static_cast<std::uint32_t>(std::countr_zero(near));
                const SearchedPatch near_patch(search, other, q);
                if (is_to_be_looked_at(search, patch, near_patch, (marked >> q & 1) != 0))
                    visit(patch, near_patch, other == block && p == q);
            }
        }
    };
    for (std::uint32_t region = block / 256; region < boxes.groups.size(); ++region) {
        std::uint32_t groups = overlapping(block_box, boxes.groups[region]);
        for (; groups != 0; groups &= groups - 1) {
            const std::uint32_t group = 16 * region + static_cast<std::uint32_t>(std::countr_zero(groups));
            if (group < block / 16) continue;
            std::uint32_t blocks = overlapping(block_box, boxes.blocks[group]);
            if (group == block / 16) blocks &= ~0u << (block % 16);
            for (; blocks != 0; blocks &= blocks - 1)
                visit_block(16 * group + static_cast<std::uint32_t>(std::countr_zero(blocks)));
        }
    }
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
