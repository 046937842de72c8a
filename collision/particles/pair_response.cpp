#include "collision/particles/pair_response.h"

#include <algorithm>

#include "engine/separating_direction.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "collision/particles/pair_response.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "collision/colliders/coulomb-inl.h"
#include "engine/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// Replaces the normals of pairs at one point, which are rare.
template <class Mask>
HWY_NOINLINE Lanes3 with_separating_directions(const Lanes3& normal, Mask coincident, const std::uint32_t* i,
                                               const std::uint32_t* j) {
    const Tag d;
    alignas(64) float x[part_lanes], y[part_lanes], z[part_lanes], is_coincident[part_lanes];
    hn::Store(normal.x, d, x);
    hn::Store(normal.y, d, y);
    hn::Store(normal.z, d, z);
    hn::Store(hn::IfThenElseZero(coincident, set(1)), d, is_coincident);
    for (std::uint32_t lane = 0; lane < part_lanes; ++lane) {
        if (is_coincident[lane] == 0) continue;
        const Vector3 apart = separating_direction(i[lane], j[lane]);
        x[lane] = apart.x();
        y[lane] = apart.y();
        z[lane] = apart.z();
    }
    return {hn::Load(d, x), hn::Load(d, y), hn::Load(d, z)};
}

void respond(const ResponseSettings& settings, const Vec4* positions, const Vec4* velocities,
             PairBatch& batch) {
    const Tag d;
    const Lanes zero = set(0), distance = set(settings.distance);
    // Padding of the last group: pairs of a particle with itself, whose results are not used.
    for (std::uint32_t k = batch.count; k % part_lanes != 0; ++k) {
        batch.i[k] = batch.j[k] = batch.i[0];
        batch.sharers[k] = 1;
    }
    for (std::uint32_t k = 0; k < batch.count; k += part_lanes) {
        const std::uint32_t *const i = &batch.i[k], *const j = &batch.j[k];
        const Lanes4 at_i = gather_rows_with_w(positions, i), at_j = gather_rows_with_w(positions, j);
        const Lanes3 apart = xyz(at_i) - xyz(at_j);
        const Lanes length = hn::Sqrt(dot(apart, apart));
        const Lanes mobility = hn::Add(at_i.w, at_j.w);
        const Lanes share = hn::Div(at_i.w, hn::Mul(mobility, load_lanes(&batch.sharers[k])));
        Lanes3 normal = hn::Div(set(1), length) * apart;
        const auto coincident = hn::Le(length, hn::Mul(set(1e-6f), distance));
        if (HWY_UNLIKELY(!hn::AllFalse(d, coincident)))
            normal = with_separating_directions(normal, coincident, i, j);

        const Lanes3 relative = gather_rows(velocities, i) - gather_rows(velocities, j);
        const Lanes approach = hn::Max(zero, hn::Neg(dot(relative, normal)));
        const Lanes3 sliding = mul_add(approach, normal, relative);
        const Lanes3 stopped = keep_where(
            hn::Gt(approach, zero), stopped_by_friction(sliding, hn::Mul(set(settings.friction), approach)));
        const Lanes overlap = hn::Max(zero, hn::Sub(distance, length));
        const Lanes3 push = overlap * normal - set(settings.h) * stopped;
        store_rows(share * push, zero, &batch.displacement[k]);
        store_rows(share * (approach * normal - stopped), zero, &batch.velocity_change[k]);
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace weft {

HWY_EXPORT(respond);

void respond_to_pairs(const ResponseSettings& settings, const Vec4* positions, const Vec4* velocities,
                      PairBatch& batch) {
    HWY_DYNAMIC_DISPATCH(respond)(settings, positions, velocities, batch);
}

}  // namespace weft
#endif
