// Collisions of a substep's motion, resolved by impact zones.

#include <algorithm>
#include <limits>

#include "cloth/contact/feature_contact.h"

namespace weft {

namespace {

// Motion in a substep below this fraction of the gap counts as rest.
constexpr float still_per_gap = 1e-3f;

float least_radius(std::span<const ContactCloth> cloths) {
    return std::ranges::min(cloths, {}, &ContactCloth::radius).radius;
}

}  // namespace

/// Finds the pairs that the motion can bring near. Its rigid part brings nothing nearer, and is left out.
void FeatureContact::find_for_zones(Parallel& parallel) {
    settler_.split(parallel, group(), displacements_.span(), CommonMotionKind::rigid);
    find(parallel, settler_.relative(), {&ContactCloth::radius, of_borders}, FullList::has_the_first);
}

/// Listed pairs that the motion brings too near, except those that are near at rest.
std::span<const std::uint32_t> FeatureContact::find_colliding_pairs() {
    const float gap = projected_gap * least_radius(cloths_);
    const std::uint32_t count = find_colliding(pairs_, start_.span(), displacements_.span(), gap,
                                               still_per_gap * gap, colliding_.span());
    const std::span<std::uint32_t> all = colliding_.span().first(count);
    const auto kept = std::ranges::remove_if(
        all, [&](std::uint32_t k) { return are_near_at_rest(pairs_.pairs[k], pairs_.corners_of_a(k)); });
    return all.first(all.size() - kept.size());
}

/// Projects the colliding pairs apart by impulses at their closest points.
void FeatureContact::part_colliding(Parallel& parallel, std::span<const std::uint32_t> colliding) {
    const float radius = least_radius(cloths_);
    std::fill_n(wanted_.data(), pairs_.size, -std::numeric_limits<float>::infinity());
    for (const std::uint32_t k : colliding)
        wanted_[k] = projected_gap * std::min(pairs_.shapes[k].normal.w, radius);
    settler_.project(parallel, group(), pairs_, {}, {.each = wanted_.span()}, projections,
                     displacements_.span());
}

// Each round resolves the pairs that earlier rounds newly brought together (Huh, Metaxas, Badler 2001,
// section 3.4), among the pairs found before the first round. A second search finds those of the resulting
// motion. The very first round adds a cluster's velocity change to its particles, so that cloth goes on
// bending within it; all others move clusters as bundles.
FeatureCounts FeatureContact::settle_by_zones(Parallel& parallel) {
    constexpr int searches = 2, rounds = 3;
    const double still = static_cast<double>(still_per_gap * projected_gap * least_radius(cloths_));
    FeatureCounts counts;
    std::span<const std::uint32_t> colliding;
    for (int search = 0; search < searches && !counts.overflowed; ++search) {
        find_for_zones(parallel);
        counts.overflowed = pairs_.overflowed;
        counts.unresolved = pairs_.overflowed ? 1 : 0;
        colliding = find_colliding_pairs();
        if (search == 0) counts.pairs = static_cast<std::uint32_t>(colliding.size());
        if (colliding.empty()) break;
        for (int round = 0; round < rounds && !colliding.empty(); ++round) {
            zones_->resolve(
                {bodies_.span(), start_.span(), pairs_, colliding},
                {.restitutions = restitutions_.span(), .as_bundles = search + round > 0, .still = still},
                displacements_.span());
            colliding = find_colliding_pairs();
        }
    }
    if (!colliding.empty()) {
        part_colliding(parallel, colliding);
        counts.unresolved += find_colliding_pairs().size();
    }
    is_uncertain_ = true;
    return counts;
}

}  // namespace weft
