// Detection of near pairs, at a substep's start and for the motion that is to be cut at its end.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cloth/contact/feature_contact.h"
#include "collision/contact/crossings/contours.h"
#include "collision/contact/crossings/touching.h"
#include "collision/contact/pairs/pair_kernels.h"

namespace weft {

namespace {

constexpr int most_tries = 4;  // times that a motion is shortened, so that its pairs fit into the list

/// Shortens displacements relative to the common motion.
void shorten(Parallel& parallel, std::span<const ParticleRange> ranges, const CommonMotion& common,
             std::span<const Vec4> starts, std::span<Vec4> displacements) {
    constexpr float shorter = 0.25f;
    for_ranges(parallel, ranges, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            set_xyz(displacements[i], give_back(common, xyz(starts[i]), xyz(displacements[i]), shorter));
    });
}

}  // namespace

void FeatureContact::set_reach(float ContactCloth::*of_cloth) {
    for (std::size_t k = 0; k < bodies_.size(); ++k) bodies_[k].reach = cloths_[k].*of_cloth;
}

void FeatureContact::find(Parallel& parallel, std::span<const Vec4> motions, const Reach& reach,
                          FullList full) {
    set_reach(reach.of_cloth);
    finder_.find(parallel, bodies_.span(), start_.span(), motions, pairs_, reach.of_borders, full,
                 uses_zones_ ? Parts::any : Parts::alike);
}

/// Turns the normals of the pairs found last as shape_moving_pairs() does, for these motions.
void FeatureContact::turn_normals(Parallel& parallel, std::span<const Vec4> motions) {
    const auto turn = [&](bool vertex_triangle, std::uint32_t begin, std::uint32_t end) {
        parallel.ranges(end - begin, [&](const BlockRange& range) {
            const std::uint32_t first = begin + range.begin;
            shape_moving_pairs(start_.data(), motions.data(), vertex_triangle,
                               std::as_const(pairs_.pairs).span().subspan(first, range.end - range.begin),
                               pairs_.shapes.data() + first);
        });
    };
    turn(true, 0, pairs_.vertex_triangle);
    turn(false, pairs_.vertex_triangle, pairs_.size);
}

// Only the rigid common motion is taken out. An affine one can bring layers within the radius, though not
// into contact, and taking it out would hide their pairs until they are too near. A rotation brings nothing
// nearer; left in, it gives a turning garment ten times as many pairs.
void FeatureContact::detect(Parallel& parallel, bool& is_crowd) {
    settler_.split(parallel, group(), displacements_.span(), CommonMotionKind::rigid);
    find_near(parallel, is_crowd);
    if (part_touching(parallel)) find_near(parallel, is_crowd);
    if (may_cross_) find_tangles(parallel);
    make_laws(parallel);
}

// If the expected motion overflows the list, the list holds the pairs that are near without motion. In a
// crowd these alone overflow it, and mostly do so again in the next substep. They are near with the motion,
// too: so a crowd is searched without motion first, which spares the other search and gives the same list.
void FeatureContact::find_near(Parallel& parallel, bool& is_crowd) {
    const auto search = [&](FullList full) {
        find(parallel, searched_.span(), {&ContactCloth::radius, of_borders}, full);
        turn_normals(parallel, searched_.span());
        has_all_near_ = !pairs_.overflowed;
    };
    const auto search_standing = [&] {
        std::ranges::fill(searched_.span(), Vec4{});
        search(FullList::has_the_first);
        is_crowd = pairs_.overflowed;
    };
    const auto is_finite = [](const Vec4& motion) { return xyz(motion).allFinite(); };
    if (is_crowd && std::ranges::all_of(settler_.relative(), is_finite)) {
        search_standing();
        if (pairs_.overflowed) return;
    }
    std::ranges::copy(settler_.relative(), searched_.data());
    search(FullList::is_empty);
    if (pairs_.overflowed) search_standing();
}

/// Moves surfaces that coincide apart by `hair` floors at the substep's start. Returns whether any moved.
/// Squeezed layers may touch, too: where they have no room, and would cross others, they stay.
bool FeatureContact::part_touching(Parallel& parallel) {
    constexpr int most_layers = 16;  // further layers are moved apart in the next substep
    constexpr float hair = 2;        // [floors]: a search within one floor does not find them again
    if (!any_touch(bodies_.span(), pairs_, start_.span())) return false;
    float floor = 0;
    for (const ContactCloth& cloth : cloths_) floor = std::max(floor, cloth.floor);
    std::ranges::copy(start_.span(), displacements_.data());  // which are known when particles arrive()
    bool any = false;
    for (int k = 0; k < most_layers; ++k) {
        if (!weft::part_touching(bodies_.span(), pairs_, hair * floor, start_.span(), base_.span())) break;
        any = true;
        find(parallel, {}, {&ContactCloth::floor}, FullList::has_the_first);
    }
    if (!any) return false;
    if (!may_cross_ && any_crosses(parallel, start_.span()))
        std::ranges::copy(displacements_.span(), start_.data());
    else
        remember_nothing();  // crossings are looked for: a mesh may be folded into itself
    return true;
}

/// Marks particles that end beyond the search's margin round the searched path (see PairNarrowing), and
/// particles that end beyond its margin round the searched end (see PairFinder::find_more).
FeatureContact::Change FeatureContact::change_of_motion(Parallel& parallel, float reach) {
    constexpr float with_rounding = 0.49f, infinity = std::numeric_limits<float>::infinity();
    const auto find_block = [&](const BlockRange& range) {
        const float radius = cloths_[body_of(bodies_.span(), range.begin)].radius;
        const float slack = with_rounding * (of_borders * radius - reach),
                    at_end = with_rounding * (radius - reach);
        Change change;
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const Vector3 way = xyz(searched_[i]), end = xyz(settler_.relative()[i]);
            const float length2 = way.squaredNorm(), length = end.norm();
            const float part = length2 > 0 ? std::clamp(way.dot(end) / length2, 0.0f, 1.0f) : 0.0f;
            const bool is_listed = (end - part * way).norm() <= slack,
                       has_come = (end - way).norm() <= at_end;
            marks_[i] = static_cast<std::uint8_t>((is_listed ? 0 : PairFinder::is_unlisted) |
                                                  (has_come ? 0 : PairFinder::has_strayed));
            change.unlisted += is_listed ? 0 : 1;
            change.marked += marks_[i] != 0 ? 1 : 0;
            change.longest = std::max(change.longest, std::isfinite(length) ? length : infinity);
        }
        return change;
    };
    const auto add = [](const Change& a, const Change& b) {
        return Change{std::max(a.longest, b.longest), a.unlisted + b.unlisted, a.marked + b.marked};
    };
    return reduce_ranges(parallel, ranges_.span(), changes_.span(), Change{}, find_block, add);
}

// Where cloth moves about as expected, the list of the substep's start has all pairs that the cut needs.
// Pairs of the particles that move otherwise are searched for once more.
void FeatureContact::find_for_cut(Parallel& parallel) {
    constexpr std::uint32_t few = 8;  // one particle in so many may be unlisted
    if (std::exchange(has_all_near_, false)) {
        settler_.split(parallel, group(), displacements_.span(), CommonMotionKind::rigid);  // as detect() did
        float reach = 0;
        for (const ContactCloth& cloth : cloths_) reach = std::max(reach, cloth.floor);
        const Change change = change_of_motion(parallel, reach);
        if (std::isfinite(change.longest) && few * change.unlisted <= start_.size()) {
            narrowing_.narrow(parallel, start_.span(), settler_.relative(), reach, change.longest, pairs_);
            if (change.marked > 0) find_more(parallel);
            return;
        }
    }
    settler_.split(parallel, group(), displacements_.span());
    find_of_motion(parallel);
}

/// Adds the pairs near marked particles that the relative motion can bring too near.
void FeatureContact::find_more(Parallel& parallel) {
    set_reach(&ContactCloth::floor);
    finder_.find_more(parallel, bodies_.span(), start_.span(), settler_.relative(), marks_.span(), pairs_);
    turn_normals(parallel, settler_.relative());
}

/// Finds the pairs that the whole of the relative motion can bring too near, for the cut.
void FeatureContact::find_of_motion(Parallel& parallel) {
    find(parallel, settler_.relative(), {&ContactCloth::floor}, FullList::is_empty);
    turn_normals(parallel, settler_.relative());
}

// The motion is shortened, not stopped: after a full stop overstretched cloth would want the same motion in
// every step, and never contract.
void FeatureContact::find_for_part_of_way(Parallel& parallel) {
    find_for_cut(parallel);
    for (int k = 0; pairs_.overflowed && k < most_tries; ++k) {
        shorten(parallel, ranges_.span(), is_pinned_ ? CommonMotion{} : settler_.common(), start_.span(),
                displacements_.span());
        find_for_cut(parallel);
    }
}

FeatureCounts FeatureContact::cut(Parallel& parallel, bool is_pushed) {
    if (uses_zones()) return settle_by_zones(parallel);
    if (may_cross_ && !tangles_.any()) tangles_.recall(bodies_.span(), memory_.span());
    SettleResult result;
    for (int k = 0;; ++k) {
        find_for_part_of_way(parallel);
        for (const ParticleRange& range : ranges_.span())
            std::copy_n(displacements_.data() + range.first, range.count, searched_.data() + range.first);
        const bool was_full = pairs_.overflowed;
        result = cut_listed(parallel, is_pushed);
        if (was_full || !pairs_.overflowed || k == most_tries) break;
        // Pairs of opened neighbours filled the list: a shorter motion has fewer.
        for (const ParticleRange& range : ranges_.span())
            std::copy_n(searched_.data() + range.first, range.count, displacements_.data() + range.first);
        shorten(parallel, ranges_.span(), is_pinned_ ? CommonMotion{} : settler_.common(), start_.span(),
                displacements_.span());
    }
    return result.draws_pins ? cut_without_common(parallel, is_pushed) : counts_of(parallel, result);
}

FeatureCounts FeatureContact::cut_without_common(Parallel& parallel, bool is_pushed) {
    for (int k = 0;; ++k) {
        for (const ParticleRange& range : ranges_.span())
            std::copy_n(searched_.data() + range.first, range.count, displacements_.data() + range.first);
        settler_.split(parallel, group(), displacements_.span(), CommonMotionKind::none);
        find_of_motion(parallel);
        const SettleResult result = cut_listed(parallel, is_pushed);
        if (!pairs_.overflowed || k == most_tries) return counts_of(parallel, result);
        shorten(parallel, ranges_.span(), CommonMotion{}, start_.span(), searched_.span());
    }
}

FeatureCounts FeatureContact::go_on(Parallel& parallel, bool is_pushed) {
    for_ranges(parallel, ranges_.span(), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const Vector3 start = xyz(start_[i]), here = start + xyz(displacements_[i]);
            const Vector3 left = start + xyz(searched_[i]) - here;
            set_xyz(displacements_[i], left);
            set_xyz(searched_[i], left);
            set_xyz(start_[i], here);
            marks_[i] = left.isZero(0) ? 0 : std::uint8_t{PairFinder::is_unlisted | PairFinder::has_strayed};
        }
    });
    const bool was_uncertain = is_uncertain_;
    settler_.split(parallel, group(), displacements_.span(), CommonMotionKind::none);
    pairs_.clear();
    find_more(parallel);
    const FeatureCounts counts = counts_of(parallel, cut_listed(parallel, is_pushed));
    is_uncertain_ |= was_uncertain;
    return counts;
}

SettleResult FeatureContact::cut_listed(Parallel& parallel, bool is_pushed) {
    float least_floor = cloths_.front().floor;
    for (const ContactCloth& cloth : cloths_) least_floor = std::min(least_floor, cloth.floor);
    BodyGroup all = group();
    all.is_pinned = is_pinned_;
    all.is_free = !is_pinned_ && !is_pushed;
    for (;;) {
        const SettleResult result = settler_.settle(parallel, all, pairs_, find_exempt(parallel),
                                                    {.floor = least_floor}, displacements_.span());
        if (result.draws_pins || result.list_was_incomplete || result.truncated == 0 ||
            !find_opened(parallel))
            return result;
        for (const ParticleRange& range : ranges_.span())
            std::copy_n(searched_.data() + range.first, range.count, displacements_.data() + range.first);
    }
}

/// Adds pairs of neighbouring patches that the search passed over. They stay apart if all particles go the
/// same fraction of their motions, but perhaps not once some are cut. Returns whether there are any.
bool FeatureContact::find_opened(Parallel& parallel) {
    if (!finder_.has_charts()) return false;
    set_reach(&ContactCloth::floor);
    for_ranges(parallel, ranges_.span(), [&](const BlockRange& range) {  // the bases are of no more use
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            set_xyz(base_[i], settler_.fractions()[i] * xyz(settler_.relative()[i]));
    });
    if (!finder_.find_opened(parallel, bodies_.span(), start_.span(), settler_.relative(), base_.span(),
                             pairs_))
        return false;
    turn_normals(parallel, settler_.relative());
    return true;
}

FeatureCounts FeatureContact::counts_of(Parallel& parallel, const SettleResult& result) {
    is_uncertain_ = result.uncertain > 0;
    if (result.list_was_incomplete && crosses_anew(parallel)) return stand_still();
    return {.pairs = near_.pairs,
            .truncated = result.truncated,
            .tangles = near_.tangles,
            .overflowed = near_.overflowed || result.list_was_incomplete};
}

// The last resort: rounding can close the gap of an unlisted pair, even if all particles move alike.
FeatureCounts FeatureContact::stand_still() {
    FeatureCounts counts = near_;
    counts.overflowed = true;
    for (const ParticleRange& range : ranges_.span()) {
        std::ranges::fill(displacements_.span().subspan(range.first, range.count), Vec4{});
        counts.truncated += range.count;
    }
    return counts;
}

}  // namespace weft
