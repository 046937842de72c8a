// Collisions of a substep's motion, resolved by impact zones.

#include <algorithm>

#include "cloth/frame/feature_contact.h"

namespace weft {

bool FeatureContact::uses_zones() const {
    return !cloths_.empty() && has_zone_memory() && std::ranges::all_of(cloths_, &ContactCloth::by_zones);
}

/// Pairs that the motion brings too near, but for what is near at rest. The mean way of all is left out: it
/// brings nothing nearer, and would list much that is on the way.
std::span<const std::uint32_t> FeatureContact::find_zone_pairs(Parallel& parallel) {
    settler_.split(parallel, island(), displacements_.span(), CommonMotionKind::translation);
    std::ranges::copy(settler_.relative(), searched_.data());
    find(parallel, searched_.span(), {&ContactCloth::radius, of_borders});
    float radius = cloths_.front().radius;
    for (const ContactCloth& cloth : cloths_) radius = std::min(radius, cloth.radius);
    const std::uint32_t count =
        find_colliding(pairs_, start_.span(), searched_.span(), projected_gap * radius, colliding_.span());
    const std::span<std::uint32_t> all = colliding_.span().first(count);
    const auto kept = std::ranges::remove_if(
        all, [&](std::uint32_t k) { return are_near_at_rest(pairs_.pairs[k], pairs_.corners_of_a(k)); });
    return all.first(all.size() - kept.size());
}

// Rounds find what the ones before newly brought together (Huh, Metaxas, Badler 2001, section 3.4). The first
// gives clusters their change of velocity, so that cloth goes on bending in them; what then still collides is
// moved as bundles; what is left is parted pair by pair where it is in its triangles, momentum kept, too.
FeatureCounts FeatureContact::settle_by_zones(Parallel& parallel) {
    constexpr int rounds = 3;
    double restitution = 1;
    for (const ContactCloth& cloth : cloths_)
        restitution = std::min(restitution, static_cast<double>(cloth.restitution));
    FeatureCounts counts;
    std::span<const std::uint32_t> colliding;
    for (int round = 0; round <= rounds; ++round) {
        colliding = find_zone_pairs(parallel);
        counts.overflowed |= pairs_.overflowed;
        if (round == 0) counts.pairs = static_cast<std::uint32_t>(colliding.size());
        if (colliding.empty() || round == rounds) break;
        zones_.resolve({bodies_, start_.span(), pairs_, colliding}, {restitution, round > 0},
                       displacements_.span());
    }
    if (!colliding.empty()) {
        std::fill_n(wanted_.data(), pairs_.size, 0.0f);
        for (const std::uint32_t k : colliding)
            wanted_[k] = projected_gap * std::min(pairs_.shapes[k].normal.w, cloths_.front().radius);
        settler_.project(parallel, island(), pairs_, {}, {.each = wanted_.span()}, projections,
                         displacements_.span());
    }
    is_uncertain_ = true;
    return counts;
}

}  // namespace weft
