// Collisions of a substep's motion, resolved by impact zones.

#include <algorithm>
#include <limits>

#include "cloth/contact/feature_contact.h"

namespace weft {

namespace {

// What moves by less than this part of the gap in a substep counts as still.
constexpr float still_per_gap = 1e-3f;

float least_radius(std::span<const ContactCloth> cloths) {
    return std::ranges::min(cloths, {}, &ContactCloth::radius).radius;
}

}  // namespace

/// All that the motion can bring near. A turn brings nothing nearer, and is left out.
void FeatureContact::find_for_zones(Parallel& parallel) {
    settler_.split(parallel, group(), displacements_.span(), CommonMotionKind::rigid);
    find(parallel, settler_.relative(), {&ContactCloth::radius, of_borders}, FullList::has_the_first);
}

/// Of what was found, pairs that the motion brings too near, but for what is near at rest.
std::span<const std::uint32_t> FeatureContact::find_colliding_pairs() {
    const float gap = projected_gap * least_radius(cloths_);
    const std::uint32_t count = find_colliding(pairs_, start_.span(), displacements_.span(), gap,
                                               still_per_gap * gap, colliding_.span());
    const std::span<std::uint32_t> all = colliding_.span().first(count);
    const auto kept = std::ranges::remove_if(
        all, [&](std::uint32_t k) { return are_near_at_rest(pairs_.pairs[k], pairs_.corners_of_a(k)); });
    return all.first(all.size() - kept.size());
}

/// Momentum is passed on pair by pair, where these are in their triangles.
void FeatureContact::part_colliding(Parallel& parallel, std::span<const std::uint32_t> colliding) {
    const float radius = least_radius(cloths_);
    std::fill_n(wanted_.data(), pairs_.size, -std::numeric_limits<float>::infinity());
    for (const std::uint32_t k : colliding)
        wanted_[k] = projected_gap * std::min(pairs_.shapes[k].normal.w, radius);
    settler_.project(parallel, group(), pairs_, {}, {.each = wanted_.span()}, projections,
                     displacements_.span());
}

// Rounds find what the ones before newly brought together (Huh, Metaxas, Badler 2001, section 3.4), among
// what was found for the motion before any; then once more for the motion after them. The very first round
// gives clusters their change of velocity, so that cloth goes on bending in them; all others move them as
// bundles.
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
