#include "collision/collider_contacts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "collision/collider_kernels.h"
#include "collision/shapes/moving_shapes.h"
#include "collision/squeeze.h"
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

// Whoever was squeezed when the substep began comes nearer to the middle in parts, and only if it is far: so
// what lies there in layers stays as it lies.
void place_between(const ClothSide& cloth, float h, const Squeeze& squeeze, const Vector3& start, bool was,
                   Vec4& position, Vec4& velocity) {
    const Vector3 along = start + h * squeeze.velocity;
    const float from_middle = squeeze.to_middle - h * squeeze.normal.dot(squeeze.velocity);
    const float way =
        was ? Parting(h).part * (from_middle - std::clamp(from_middle, -cloth.thickness, cloth.thickness))
            : squeeze.normal.dot(xyz(position) - along) + squeeze.to_middle;
    set_xyz(position, along + way * squeeze.normal);
    set_xyz(velocity, squeeze.velocity);
}

/// What several colliders have met, or what was squeezed before, is found out about and put where it belongs.
/// What a step finds deep in two was not squeezed by them, and is to come out, as far as is known.
void settle_squeezed(std::span<const ColliderMotion> colliders, const SomeColliders& near,
                     const ClothSide& cloth, float h, const CollidingParticles& particles,
                     std::span<const std::uint32_t> met) {
    constexpr float deep = 5e-3f;
    if (particles.starts.empty()) return;
    const auto was_squeezed = [&](std::uint32_t k) {
        return !particles.held.empty() && particles.held[k].w < 0;
    };
    const auto may_be = [&](std::uint32_t k) {
        return (met[k] > 1 || was_squeezed(k)) && particles.positions[k].w > 0;
    };
    const auto size = static_cast<std::uint32_t>(particles.positions.size());
    std::uint32_t first = 0;
    while (first < size && !may_be(first)) ++first;
    if (first == size) return;
    // Where it began, and those that were not squeezed there once more where they have come to.
    SqueezedParticles at_start, at_end;
    for (std::uint32_t k = first; k < size; ++k)
        if (may_be(k)) at_start.add(k, was_squeezed(k), particles.starts[k]);
    find_squeezes(colliders, near, cloth, h, at_start);
    const auto place = [&](const SqueezedParticles& all, std::uint32_t c, bool was) {
        const std::uint32_t k = all.indices[c];
        place_between(cloth, h, all.squeezes[c], xyz(particles.starts[k]), was, particles.positions[k],
                      particles.velocities[k]);
        if (particles.held.empty()) return;
        particles.held[k] = to_vec4(all.squeezes[c].normal, -1);
        particles.touching[k / 16] = 1;
    };
    for (std::uint32_t c = 0; c < at_start.count; ++c) {
        const std::uint32_t k = at_start.indices[c];
        const Squeeze& squeeze = at_start.squeezes[c];
        const bool may_have_been = particles.held.empty() || was_squeezed(k);
        if (squeeze.is_squeezed && may_have_been) {
            place(at_start, c, true);
        } else if (was_squeezed(k)) {
            particles.held[k].w = 0;
        } else if (squeeze.depth_before < deep) {
            at_end.add(k, false, particles.positions[k]);
        }
    }
    if (at_end.count == 0) return;
    find_squeezes(colliders, near, cloth, h, at_end);
    for (std::uint32_t c = 0; c < at_end.count; ++c)
        if (at_end.squeezes[c].is_squeezed) place(at_end, c, false);
}

std::uint32_t collide_block(std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h,
                            const CollidingParticles& particles) {
    const std::span<const Vec4> starts = particles.starts;
    CollidingBlock block{.positions = particles.positions,
                         .velocities = particles.velocities,
                         .held = particles.held,
                         .starts = starts,
                         .paths = paths_of(starts, particles.positions),
                         .parting = particles.parting};
    SomeColliders near;
    for (const ColliderMotion& motion : colliders)
        if_near(motion, h, cloth, 0, block.paths, [&](const auto& shape, const Meeting& meeting) {
            near.add(static_cast<std::uint32_t>(&motion - colliders.data()));
            collide(shape,
                    {.thickness = thickness_of(motion, cloth),
                     .friction = friction_of(motion, cloth),
                     .h = h,
                     .restitution = restitution_of(motion, cloth),
                     .least_bounce = cloth.least_bounce,
                     .meeting = starts.empty() ? Meeting{} : meeting},
                    block);
        });
    if (near.count() > 1) settle_squeezed(colliders, near, cloth, h, particles, block.met);
    return std::accumulate(block.met.begin(), block.met.end(), 0u,
                           [](std::uint32_t sum, std::uint32_t met) { return sum + (met & 1); });
}

/// Of the particles of a block.
CollidingParticles part_of(const CollidingParticles& all, const BlockRange& range) {
    const std::uint32_t size = range.end - range.begin;
    const auto of_block = [&](auto span) { return span.empty() ? span : span.subspan(range.begin, size); };
    const std::size_t group = range.begin / 16, groups = (size + 15) / 16;
    return {.positions = of_block(all.positions),
            .velocities = of_block(all.velocities),
            .starts = of_block(all.starts),
            .held = of_block(all.held),
            .touching = all.touching.empty() ? all.touching : all.touching.subspan(group, groups),
            .parting = of_block(all.parting)};
}

void clear(NearSurfaces& near, float reach) {
    for (BlockLanes* lanes : {&near.surfaces, &near.motions})
        for (auto* component : {&lanes->x, &lanes->y, &lanes->z, &lanes->w}) component->fill(0);
    near.surfaces.w.fill(reach);
}

}  // namespace

std::uint32_t collide(Parallel& parallel, std::span<const ColliderMotion> colliders, const ClothSide& cloth,
                      float h, const CollidingParticles& particles, std::span<std::uint32_t> block_partials) {
    if (colliders.empty()) return 0;
    const auto block = [&](const BlockRange& range) {
        return collide_block(colliders, cloth, h, part_of(particles, range));
    };
    return parallel.reduce(static_cast<std::uint32_t>(particles.positions.size()), block_partials, 0u, block,
                           std::plus<>{});
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
                     const Told& told, NearSurfaces& near) {
    bool is_clear = true, found = false;
    for (const ColliderMotion& motion : colliders)
        if_near(motion, h, cloth, reach, paths, [&](const auto& shape, const Meeting& meeting) {
            if (is_clear) clear(near, reach);
            is_clear = false;
            const ContactSettings settings{.thickness = thickness_of(motion, cloth),
                                           .friction = told(motion),
                                           .h = h,
                                           .meeting = starts.empty() ? Meeting{} : meeting};
            found |= find_nearest(shape, {settings, reach, starts, size}, near);
        });
    return found;
}

}  // namespace

bool find_near_surfaces(std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h,
                        float reach, std::span<const Vec4> starts, std::span<const Vec4> positions,
                        float gamma, std::span<const Vec4> velocities, NearSurfaces& near) {
    const BlockPaths paths = place(starts, positions, gamma, velocities, near.points);
    return find_nearest_of(
        colliders, cloth, h, reach, starts, paths, static_cast<std::uint32_t>(positions.size()),
        [&](const ColliderMotion& motion) { return friction_of(motion, cloth); }, near);
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
