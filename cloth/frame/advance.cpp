#include "cloth/frame/advance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/frame/advance.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "engine/simd/packed_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

HWY_INLINE PackedRows limited(const PackedRows& velocities, float max_speed) {
    const Lanes3 v = unpacked(velocities);
    const Lanes squared = dot(v, v), limit = hn::Set(Tag(), max_speed);
    const auto too_fast = hn::Gt(squared, hn::Mul(limit, limit));
    if (HWY_LIKELY(hn::AllFalse(Tag(), too_fast))) return velocities;
    const Lanes factor = hn::IfThenElse(too_fast, hn::Div(limit, hn::Sqrt(squared)), hn::Set(Tag(), 1.0f));
    return packed(factor * v, hn::Zero(Tag()));
}

void advance_block(const StepEquation& equation, const Advance& change, const BlockRange& range) {
    const Lanes gamma = hn::Set(Tag(), equation.gamma);
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const PackedRows v = limited(load_packed(&change.solved[i]), change.max_speed);
        const PackedRows x = mul_add(gamma, v, load_packed(&equation.base_positions[i]));  // w stays: 0 in v
        if (change.history != nullptr) {
            const HistoryRows record = change.history->rows(i);
            store_packed(x - load_packed(&equation.positions[i]), record.displacements);
            store_packed(v - load_packed(&equation.velocities[i]), record.velocity_changes);
            store_packed(x, record.arrivals);
        }
        store_packed(v, &change.velocities[i]);
        store_packed(x, &change.positions[i]);
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // what does not depend on the machine
namespace weft {

HWY_EXPORT(advance_block);

void advance(Parallel& parallel, const StepEquation& equation, const Advance& change) {
    if (change.history != nullptr) change.history->set_step(equation.h);
    parallel.ranges(static_cast<std::uint32_t>(change.positions.size()), [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(advance_block)(equation, change, range);
    });
}

}  // namespace weft
#endif
