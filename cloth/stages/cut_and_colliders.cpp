// After the cut: the common motion may not move what is cut into colliders, or to other groups.

#include <algorithm>

#include "cloth/stages/contact_step.h"
#include "cloth/stages/worn_step.h"

namespace weft {

namespace {

/// Whether the cut left a particle inside a collider, deeper than both its start and its wanted end.
bool is_taken_into_colliders(Worker& worker, const FeatureContact& space, std::size_t body, Cloth& cloth,
                             float h) {
    const std::span<const ColliderMotion> colliders = colliders_of(worker, cloth);
    if (colliders.empty() || !meets_in_equation(cloth.settings)) return false;
    const std::span<const Vec4> starts = space.starts(body), wanted = space.uncut(body),
                                had = space.displacements(body);
    const float least = -0.5f * cloth.settings.thickness - 1e-4f;  // [m]: half the thickness, and rounding
    const auto is_cut = [&](std::uint32_t i) {
        return starts[i].w > 0 && !(xyz(had[i]) - xyz(wanted[i])).isZero(0);
    };
    const auto find_block = [&](const BlockRange& range) {
        bool any = false;
        for (std::uint32_t i = range.begin; i < range.end && !any; ++i) any = is_cut(i);
        if (!any) return 0u;
        const ClothSide side = cloth.side().part(range.begin, range.end - range.begin);
        const auto find = [&](std::span<const Vec4> displacements, float part, NearSurfaces& near) {
            return find_near_surfaces(colliders, side, h, 0, {},
                                      starts.subspan(range.begin, range.end - range.begin), part,
                                      displacements.subspan(range.begin, range.end - range.begin), near);
        };
        NearSurfaces after, aim, before;
        if (!find(had, 1, after)) return 0u;
        const auto depth_of = [](const NearSurfaces& near, std::uint32_t k, bool found) {
            return found ? near.surfaces.w[k] : 0.0f;
        };
        any = false;
        for (std::uint32_t i = range.begin; i < range.end; ++i)
            any = any || (is_cut(i) && after.surfaces.w[i - range.begin] < least);
        if (!any) return 0u;
        const bool at_aim = find(wanted, 1, aim), at_start = find(had, 0, before);
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const std::uint32_t k = i - range.begin;
            const float allowed = std::min({least, depth_of(aim, k, at_aim), depth_of(before, k, at_start)});
            if (is_cut(i) && after.surfaces.w[k] < allowed) return 1u;
        }
        return 0u;
    };
    return worker.parallel.reduce(cloth.state.size(), cloth.partial_counts.span(), 0u, find_block,
                                  [](std::uint32_t a, std::uint32_t b) { return a | b; }) != 0;
}

}  // namespace

// A particle that is cut follows the common motion, which knows neither colliders nor other groups. If the
// motion brings a particle to either, the cut is repeated without common motion: each particle then ends
// between its start and the end that the solver wanted, both of which are outside of colliders and in the
// cloth's own space.
void keep_common_motion_out(const Simulation& world, Worker& worker, FeatureContact& space,
                            std::span<Cloth* const> cloths, float h) {
    FeatureCounts& counts = cloths.front()->feature_counts;
    if (counts.truncated == 0 || !space.had_common()) return;
    bool any = false;
    for (std::size_t k = 0; k < cloths.size() && !any; ++k)
        any = is_taken_out_of_own_space(world, worker, space, k, *cloths[k]) ||
              is_taken_into_colliders(worker, space, k, *cloths[k], h);
    if (!any) return;
    const bool overflowed = counts.overflowed;
    counts = space.cut_without_common(worker.parallel, true);
    counts.overflowed |= overflowed;
}

}  // namespace weft
