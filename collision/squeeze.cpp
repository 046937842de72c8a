#include "collision/squeeze.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weft {

namespace {

// Where surfaces meet at a corner a place beside it counts as free if it is within the thickness, and this.
constexpr float least_way_out = 2e-3f;

// Who was squeezed is until there is one within this part of that.
constexpr float stays_squeezed = 0.5f;

struct Met {
    float gap = 0;  // below 0 [m]
    Vector3 normal = Vector3::Zero(), velocity = Vector3::Zero();
    std::size_t collider = std::numeric_limits<std::size_t>::max();
};

/// Calls use(k, what it meets) for each particle that is nearer than the thickness to the collider.
template <class Use>
bool for_each_met(std::span<const ColliderMotion> colliders, std::size_t collider, const ClothSide& cloth,
                  float h, const SqueezedParticles& particles, const Use& use) {
    const std::span<const Vec4> points = std::span(particles.points).first(particles.count);
    NearSurfaces near;
    if (!find_near_surfaces(colliders.subspan(collider, 1), cloth, h, 0, {}, points, 0, points, near))
        return false;
    for (std::uint32_t k = 0; k < particles.count; ++k)
        if (near.surfaces.w[k] < 0)
            use(k, Met{near.surfaces.w[k],
                       {near.surfaces.x[k], near.surfaces.y[k], near.surfaces.z[k]},
                       {near.motions.x[k], near.motions.y[k], near.motions.z[k]},
                       collider});
    return true;
}

/// How far it is from a point to where two planes both let it be, if they do not look the same way [m].
float way_out_of(const Met& a, const Met& b) {
    const float c = a.normal.dot(b.normal);
    if (!(c < 0)) return 0;
    return -0.5f * (a.gap + b.gap) / std::sqrt(std::max(0.5f * (1 + c), 1e-12f));
}

}  // namespace

void find_squeezes(std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h,
                   SqueezedParticles& particles) {
    SomeColliders all;
    for (std::uint32_t m = 0; m < colliders.size(); ++m) all.add(m);
    find_squeezes(colliders, all, cloth, h, particles);
}

void find_squeezes(std::span<const ColliderMotion> colliders, const SomeColliders& which,
                   const ClothSide& cloth, float h, SqueezedParticles& particles) {
    const std::uint32_t count = particles.count;
    for (std::uint32_t k = count; k % 16 != 0; ++k) particles.points[k] = {};
    std::fill_n(particles.squeezes.begin(), count, Squeeze{});
    std::array<Met, block_size> deepest;
    SomeColliders near;
    which.for_each(colliders.size(), [&](std::uint32_t m) {
        const auto keep_deepest = [&](std::uint32_t k, const Met& met) {
            if (met.gap < deepest[k].gap) deepest[k] = met;
        };
        if (for_each_met(colliders, m, cloth, h, particles, keep_deepest)) near.add(m);
    });
    if (near.count() < 2) return;

    const auto margin = [&](std::size_t m) { return colliders[m].end.thickness; };
    const auto depth_before = [&](const Met& met) { return -(met.gap + h * met.normal.dot(met.velocity)); };
    std::array<float, block_size> ways{};  // out of the worst pair
    near.for_each(colliders.size(), [&](std::uint32_t m) {
        for_each_met(colliders, m, cloth, h, particles, [&](std::uint32_t k, const Met& met) {
            const Met& first = deepest[k];
            const float way = way_out_of(first, met);
            if (first.collider == m || !(way > ways[k])) return;
            ways[k] = way;
            const float within =
                std::max(cloth.thickness + std::max(margin(first.collider), margin(m)), least_way_out);
            const Vector3 apart = first.normal - met.normal;
            const float length = apart.norm();
            particles.squeezes[k] = {.is_squeezed = way > (particles.was[k] ? stays_squeezed : 1) * within,
                                     .normal = apart / length,
                                     .velocity = 0.5f * (first.velocity + met.velocity),
                                     .to_middle = (met.gap - first.gap) / length,
                                     .depth_before = std::min(depth_before(first), depth_before(met))};
        });
    });
}

}  // namespace weft
