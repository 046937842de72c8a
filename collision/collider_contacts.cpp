#include "collision/collider_contacts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "collision/collider_kernels.h"
#include "collision/shapes/moving_shapes.h"
#include "collision/thin/whole_triangles.h"
#include "engine/vector.h"

namespace weft {

namespace {

float thickness_of(const ColliderMotion& motion, const ClothSide& cloth) {
    return cloth.thickness + motion.end.thickness;
}
float friction_of(const ColliderMotion& motion, const ClothSide& cloth) {
    return cloth.friction * motion.end.friction;
}
float restitution_of(const ColliderMotion& motion, const ClothSide& cloth) {
    return std::max(cloth.restitution, motion.end.restitution);
}

/// Bodies give way within a substep, and what deforms may do so by any way: that is the substep's own doing.
FoundDepth found_depth(const ColliderMotion& motion, const ClothSide& cloth, float h) {
    if (motion.body >= 0 || motion.rate != 0) return {};
    return {.least = std::max(FoundDepth::speed * h, cloth.brought)};
}

/// Calls use(a moving shape, how it may be met), unless it is clear of the paths by more than the thickness
/// and the reach, or not for this cloth.
template <class Use>
void if_near(const ColliderMotion& motion, float h, const ClothSide& cloth, float beyond,
             const BlockPaths& paths, const Use& use) {
    if (!cloth.meets(motion.end)) return;
    const Pace pace{h, motion.fastest};
    const Reach reach{thickness_of(motion, cloth), beyond};
    with_shapes(motion, [&](const auto& start, const auto& end) {
        if (const auto meeting = may_meet(start, end, pace, reach, paths))
            use(moving(start, end, pace), *meeting);
    });
}

std::uint32_t collide_block(std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h,
                            const CollidingParticles& particles) {
    const std::span<const Vec4> starts = particles.starts;
    CollidingBlock block{.positions = particles.positions,
                         .velocities = particles.velocities,
                         .held = particles.held,
                         .starts = starts,
                         .paths = paths_of(starts, particles.positions),
                         .factors = particles.factors};
    for (const ColliderMotion& motion : colliders)
        if_near(motion, h, cloth, 0, block.paths, [&](const auto& shape, const Meeting& meeting) {
            collide(shape,
                    {.thickness = thickness_of(motion, cloth),
                     .friction = friction_of(motion, cloth),
                     .h = h,
                     .of_cloth = cloth.thickness,
                     .restitution = restitution_of(motion, cloth),
                     .least_bounce = cloth.least_bounce,
                     .found = found_depth(motion, cloth, h),
                     .meeting = starts.empty() ? Meeting{} : meeting},
                    block);
        });
    return std::accumulate(block.met.begin(), block.met.end(), 0u);
}

/// Of the particles of a block.
CollidingParticles part_of(const CollidingParticles& all, const BlockRange& range) {
    const std::uint32_t size = range.end - range.begin;
    const auto of_block = [&](auto span) { return span.empty() ? span : span.subspan(range.begin, size); };
    return {.positions = of_block(all.positions),
            .velocities = of_block(all.velocities),
            .starts = of_block(all.starts),
            .held = of_block(all.held),
            .factors = {of_block(all.factors.thickness), of_block(all.factors.friction)}};
}

void clear(NearSurfaces& near, float reach) {
    for (BlockLanes* lanes : {&near.surfaces, &near.motions})
        for (auto* component : {&lanes->x, &lanes->y, &lanes->z, &lanes->w}) component->fill(0);
    near.surfaces.w.fill(reach);
}

/// The i-th particle is nearest to this collider, and its surface goes with the body.
void take_body(const ColliderMotion& motion, std::size_t i, NearSurfaces& near,
               std::span<std::int32_t> bodies) {
    bodies[i] = motion.body;
    if (motion.body < 0) return;
    const Vector3 arm = Vector3(near.points.x[i], near.points.y[i], near.points.z[i]) - motion.centre;
    const Vector3 v = motion.velocity + motion.spin.cross(arm);
    near.motions.x[i] = v.x();
    near.motions.y[i] = v.y();
    near.motions.z[i] = v.z();
}

}  // namespace

std::uint32_t collide(Parallel& parallel, std::span<const ColliderMotion> colliders, const ClothSide& cloth,
                      float h, const CollidingParticles& particles, std::span<std::uint32_t> block_partials) {
    if (colliders.empty()) return 0;
    const auto block = [&](const BlockRange& range) {
        return collide_block(colliders, cloth, h, part_of(particles, range));
    };
    const std::uint32_t met = parallel.reduce(static_cast<std::uint32_t>(particles.positions.size()),
                                              block_partials, 0u, block, std::plus<>{});
    if (particles.whole == nullptr || particles.starts.empty()) return met;
    return met + particles.whole->keep_out(parallel, colliders, cloth, h, particles);
}

std::uint32_t parts_to_meet(Parallel& parallel, std::span<const ColliderMotion> colliders,
                            const ClothSide& cloth, float h, std::uint32_t most,
                            std::span<const Vec4> positions, std::span<const Vec4> velocities,
                            std::span<std::uint32_t> block_partials) {
    std::uint32_t parts = 1;
    for (const ColliderMotion& motion : colliders) {
        const Sweeping fast = with_shapes(motion, [&](const auto& start, const auto& end) {
            return sweeping(start, end, {h, motion.fastest}, thickness_of(motion, cloth));
        });
        if (!(fast.way > fast.thin_as_a_whole)) continue;
        const auto block = [&](const BlockRange& range) {
            const std::uint32_t size = range.end - range.begin;
            const std::span<const Vec4> starts = positions.subspan(range.begin, size);
            NearSurfaces near;
            if (!find_near_surfaces({&motion, 1}, cloth, h, 0, starts, starts, h,
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

namespace {

/// Among points that have been placed. told(motion): w of the surfaces' motions.
template <class Told>
bool find_nearest_of(std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h, float reach,
                     std::span<const Vec4> starts, const BlockPaths& paths, std::uint32_t size,
                     const Told& told, NearSurfaces& near, std::span<std::int32_t> bodies = {}) {
    std::ranges::fill(bodies, -1);
    std::array<float, block_size> before;
    bool is_clear = true, found = false;
    for (const ColliderMotion& motion : colliders)
        if_near(motion, h, cloth, reach, paths, [&](const auto& shape, const Meeting& meeting) {
            if (is_clear) clear(near, reach);
            is_clear = false;
            const ContactSettings settings{.thickness = thickness_of(motion, cloth),
                                           .friction = told(motion),
                                           .h = h,
                                           .found = found_depth(motion, cloth, h),
                                           .meeting = starts.empty() ? Meeting{} : meeting};
            if (!bodies.empty()) before = near.surfaces.w;
            found |= find_nearest(shape, {settings, reach, starts, size}, near);
            for (std::size_t i = 0; i < bodies.size(); ++i)
                if (near.surfaces.w[i] < before[i]) take_body(motion, i, near, bodies);
        });
    return found;
}

}  // namespace

bool find_near_surfaces(std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h,
                        float reach, std::span<const Vec4> starts, std::span<const Vec4> positions,
                        float gamma, std::span<const Vec4> velocities, NearSurfaces& near,
                        std::span<std::int32_t> bodies) {
    const BlockPaths paths = place(starts, positions, gamma, velocities, near.points);
    return find_nearest_of(
        colliders, cloth, h, reach, starts, paths, static_cast<std::uint32_t>(positions.size()),
        [&](const ColliderMotion& motion) { return friction_of(motion, cloth); }, near, bodies);
}

bool find_bouncing_surfaces(std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h,
                            float reach, std::span<const Vec4> positions, float gamma,
                            std::span<const Vec4> velocities, NearSurfaces& near) {
    const BlockPaths paths = place({}, positions, gamma, velocities, near.points);
    return find_nearest_of(
        colliders, cloth, h, reach, {}, paths, static_cast<std::uint32_t>(positions.size()),
        [&](const ColliderMotion& motion) { return restitution_of(motion, cloth); }, near);
}

}  // namespace weft
