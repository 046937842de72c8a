#include "collision/particles/velocity_filter.h"

#include <functional>

#include "engine/vector.h"

namespace weft {

namespace {

/// v -= n n^T v where n^T v < 0 (Levin 2020, assignment 4, "Collision Resolution").
std::uint32_t filter_block(const NearSurfaces& near, std::span<Vec4> velocities) {
    std::uint32_t inside = 0;
    for (std::uint32_t k = 0; k < velocities.size(); ++k) {
        if (!(near.surfaces.w[k] < 0) || !(near.points.w[k] > 0)) continue;
        ++inside;
        const Vector3 n(near.surfaces.x[k], near.surfaces.y[k], near.surfaces.z[k]);
        const Vector3 of_surface(near.motions.x[k], near.motions.y[k], near.motions.z[k]);
        const Vector3 v = xyz(velocities[k]);
        const float out = n.dot(v - of_surface);
        if (out < 0) set_xyz(velocities[k], v - out * n);
    }
    return inside;
}

}  // namespace

std::uint32_t filter_velocities(Parallel& parallel, std::span<const ColliderMotion> colliders,
                                const ClothSide& cloth, float h, std::span<const Vec4> positions,
                                std::span<Vec4> velocities, std::span<std::uint32_t> block_partials) {
    if (colliders.empty()) return 0;
    const auto block = [&](const BlockRange& range) {
        const std::uint32_t size = range.end - range.begin;
        NearSurfaces near;
        const std::span<Vec4> of_block = velocities.subspan(range.begin, size);
        alignas(64) static constexpr std::array<float, block_size> none{};
        const std::span<const float> of_block_none = std::span(none).first(size);
        ClothSide side{.thickness = of_block_none, .friction = of_block_none, .mask = cloth.mask};
        if (!cloth.masks.empty()) side.masks = cloth.masks.subspan(range.begin, size);
        const bool any = find_near_surfaces(colliders, side, h, 0, {}, positions.subspan(range.begin, size),
                                            0, of_block, near);
        return any ? filter_block(near, of_block) : 0u;
    };
    return parallel.reduce(static_cast<std::uint32_t>(positions.size()), block_partials, 0u, block,
                           std::plus<>{});
}

}  // namespace weft
