#include "cloth/frame/history.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/frame/history.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/system/sparse/stencil-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

// Curtiss and Hirschfelder 1952: x_base = (4 x_n - x_n-1) / 3 = x_n + (x_n - x_n-1) / 3, and v likewise. A
// pinned particle's bases are such that x_base + gamma v is x_n + h v.
void make_bases(const HistoryRows& rows, const BlockRange& range, float h, const Vec4* positions,
                const Vec4* velocities) {
    const Tag d;
    const Lanes third = hn::Set(d, 1.0f / 3.0f), zero = hn::Zero(d);
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const Lanes4 position = load_rows(positions + i);
        const Lanes3 x = xyz(position), v = xyz(load_rows(velocities + i)),
                     arrival = xyz(load_rows(rows.arrivals + i));
        const auto is_free = hn::Ne(position.w, zero);
        const auto went_on =
            hn::And(is_free,
                    hn::And(hn::Eq(x.x, arrival.x), hn::And(hn::Eq(x.y, arrival.y), hn::Eq(x.z, arrival.z))));
        const Lanes3 displacement =
            either(went_on, xyz(load_rows(rows.displacements + i)), hn::Set(d, h) * v);
        const Lanes3 change = keep_where(is_free, xyz(load_rows(rows.velocity_changes + i)));
        store_rows(mul_add(third, displacement, x), position.w, rows.base_positions + i);
        store_rows(mul_add(third, change, v), zero, rows.base_velocities + i);
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // what does not depend on the machine
namespace weft {

HWY_EXPORT(make_bases);

void History::begin(Parallel& parallel, const ClothState& state) {
    const HistoryRows rows = this->rows();
    parallel.ranges(state.size(), [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(make_bases)(rows, range, h_, state.positions.data(), state.velocities.data());
    });
}

std::size_t History::bytes() const noexcept {
    return displacements_.bytes() + velocity_changes_.bytes() + arrivals_.bytes() + base_positions_.bytes() +
           base_velocities_.bytes();
}

}  // namespace weft
#endif
