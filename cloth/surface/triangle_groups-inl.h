// Loads and sums by TriangleGroups. Included like cloth/equation/sparse/stencil-inl.h.

#if defined(WEFT_CLOTH_SURFACE_TRIANGLE_GROUPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_CLOTH_SURFACE_TRIANGLE_GROUPS_INL_H
#undef WEFT_CLOTH_SURFACE_TRIANGLE_GROUPS_INL_H
#else
#define WEFT_CLOTH_SURFACE_TRIANGLE_GROUPS_INL_H
#endif

#include "cloth/surface/triangle_groups.h"
#include "engine/simd/packed_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// The particles' rows at corner k of the triangles from row t on.
HWY_INLINE PackedRows corner_rows(const TriangleGroups& groups, std::uint32_t t, std::uint32_t k,
                                  const Vec4* particle_rows) {
    const std::uint32_t group = t / TriangleGroups::lanes, lane = t % TriangleGroups::lanes;
    const std::uint32_t source = groups.corner_sources[group * 3 + k];
    if (source < TriangleGroups::listed) return load_packed(particle_rows + source + lane);
    return gather_packed(particle_rows, &groups.corner_lists[source - TriangleGroups::listed + lane]);
}

/// The sums of triangles' rows over the triangles of the particles from i on.
HWY_INLINE PackedRows sum_over_triangles(const TriangleGroups& groups, std::uint32_t i,
                                         const Vec4* triangle_rows) {
    const std::uint32_t group = i / TriangleGroups::lanes, lane = i % TriangleGroups::lanes;
    const Vec4* const own = triangle_rows + TriangleGroups::own_rows(group * TriangleGroups::lanes) + lane;
    PackedRows sum = load_packed(own) + load_packed(own + TriangleGroups::lanes);
    for (std::uint32_t k = groups.first_runs[group]; k < groups.first_runs[group + 1]; ++k)
        sum = sum + load_packed(triangle_rows + groups.sum_runs[k] + lane);
    for (std::uint32_t k = groups.first_lists[group]; k < groups.first_lists[group + 1]; ++k)
        sum = sum + gather_packed(triangle_rows, &groups.sum_lists[k * TriangleGroups::lanes + lane]);
    return sum;
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
