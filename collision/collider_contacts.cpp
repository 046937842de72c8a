#include "collision/collider_contacts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "collision/collider_kernels.h"
#include "collision/shapes/moving_shapes.h"

namespace weft {

namespace {

/// Calls use(a moving shape, how it may be met), unless it is clear of the paths by more than the reach.
template <class Use>
void if_near(const ColliderMotion& motion, float h, const Reach& reach, const BlockPaths& paths,
             const Use& use) {
    const Pace pace{h, motion.fastest};
    with_shapes(motion, [&](const auto& start, const auto& end) {
        if (const auto meeting = may_meet(start, end, pace, reach, paths))
            use(moving(start, end, pace), *meeting);
    });
}

std::uint32_t collide_block(std::span<const ColliderMotion> colliders, float thickness, float friction,
                            float h, std::span<const Vec4> held, std::span<const Vec4> starts,
                            std::span<Vec4> positions, std::span<Vec4> velocities,
                            const ParticleFactors& factors) {
    CollidingBlock block{positions, velocities, held, starts, factors, paths_of(starts, positions)};
    for (const ColliderMotion& motion : colliders)
        if_near(motion, h, {thickness, 0}, block.paths, [&](const auto& shape, const Meeting& meeting) {
            collide(shape,
                    {thickness, friction * motion.end.friction, h, starts.empty() ? Meeting{} : meeting},
                    block);
        });
    return std::accumulate(block.met.begin(), block.met.end(), 0u);
}

void clear(NearSurfaces& near, float reach) {
    for (BlockLanes* lanes : {&near.surfaces, &near.motions})
        for (auto* component : {&lanes->x, &lanes->y, &lanes->z, &lanes->w}) component->fill(0);
    near.surfaces.w.fill(reach);
}

}  // namespace

std::uint32_t collide(Parallel& parallel, std::span<const ColliderMotion> colliders, float thickness,
                      float friction, float h, std::span<const Vec4> held, std::span<const Vec4> starts,
                      std::span<Vec4> positions, std::span<Vec4> velocities,
                      std::span<std::uint32_t> block_partials, const ParticleFactors& factors) {
    if (colliders.empty()) return 0;
    const auto block = [&](const BlockRange& range) {
        const std::uint32_t size = range.end - range.begin;
        const auto of_block = [&](auto all) {
            return all.empty() ? all : all.subspan(range.begin, size);
        };
        return collide_block(colliders, thickness, friction, h, of_block(held), of_block(starts),
                             positions.subspan(range.begin, size), velocities.subspan(range.begin, size),
                             {of_block(factors.thickness), of_block(factors.friction)});
    };
    return parallel.reduce(static_cast<std::uint32_t>(positions.size()), block_partials, 0u, block,
                           std::plus<>{});
}

std::uint32_t parts_to_meet(Parallel& parallel, std::span<const ColliderMotion> colliders, float thickness,
                            float h, std::uint32_t most, std::span<const Vec4> positions,
                            std::span<const Vec4> velocities, std::span<std::uint32_t> block_partials) {
    std::uint32_t parts = 1;
    for (const ColliderMotion& motion : colliders) {
        const Sweeping fast = with_shapes(motion, [&](const auto& start, const auto& end) {
            return sweeping(start, end, {h, motion.fastest}, thickness);
        });
        if (!(fast.way > fast.thin_as_a_whole)) continue;
        const auto block = [&](const BlockRange& range) {
            const std::uint32_t size = range.end - range.begin;
            const std::span<const Vec4> starts = positions.subspan(range.begin, size);
            NearSurfaces near;
            if (!find_near_surfaces({&motion, 1}, thickness, 0, h, 0, starts, starts, h,
                                    velocities.subspan(range.begin, size), near))
                return 1u;
            float longest = 0;
            for (std::uint32_t i = range.begin; i < range.end; ++i)
                if (positions[i].w > 0)
                    longest = std::max(longest, (h * xyz(velocities[i]) - fast.travel).squaredNorm());
            const float wanted = std::ceil(std::sqrt(longest) / (2 * fast.thin_as_a_whole));
            return wanted < static_cast<float>(most) ? std::max(static_cast<std::uint32_t>(wanted), 1u)
                                                     : most;
        };
        parts = parallel.reduce(static_cast<std::uint32_t>(positions.size()), block_partials, parts, block,
                                [](std::uint32_t a, std::uint32_t b) { return std::max(a, b); });
    }
    return parts;
}

bool find_near_surfaces(std::span<const ColliderMotion> colliders, float thickness, float friction, float h,
                        float reach, std::span<const Vec4> starts, std::span<const Vec4> positions,
                        float gamma, std::span<const Vec4> velocities, NearSurfaces& near) {
    const auto size = static_cast<std::uint32_t>(positions.size());
    const BlockPaths paths = place(starts, positions, gamma, velocities, near.points);
    bool is_clear = true, found = false;
    for (const ColliderMotion& motion : colliders)
        if_near(motion, h, {thickness, reach}, paths, [&](const auto& shape, const Meeting& meeting) {
            if (is_clear) clear(near, reach);
            is_clear = false;
            const ContactSettings settings{thickness, friction * motion.end.friction, h,
                                           starts.empty() ? Meeting{} : meeting};
            found |= find_nearest(shape, {settings, reach, starts, size}, near);
        });
    return found;
}

}  // namespace weft
