#include "cloth/motion/advance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/motion/advance.cpp"
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
        const PackedRows x = mul_add(gamma, v, load_packed(&equation.base_positions[i]));  // keeps w: v.w 0
        if (StepRecord* const record = change.record) {
            store_packed(x - load_packed(&equation.positions[i]), &record->displacements[i]);
            store_packed(v - load_packed(&equation.velocities[i]), &record->velocity_changes[i]);
            store_packed(x, &record->arrivals[i]);
        }
        store_packed(v, &change.velocities[i]);
        store_packed(x, &change.positions[i]);
    }
}

void limit_block(const BlockRange& range, float max_speed, Vec4* velocities) {
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes)
        store_packed(limited(load_packed(velocities + i), max_speed), velocities + i);
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // independent of the SIMD target
namespace weft {

HWY_EXPORT(advance_block);
HWY_EXPORT(limit_block);

void advance(Parallel& parallel, const StepEquation& equation, const Advance& change) {
    if (change.record != nullptr) change.record->h = equation.h;
    parallel.ranges(static_cast<std::uint32_t>(change.positions.size()), [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(advance_block)(equation, change, range);
    });
}

void limit_speeds(Parallel& parallel, float max_speed, std::span<Vec4> velocities) {
    parallel.ranges(static_cast<std::uint32_t>(velocities.size()), [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(limit_block)(range, max_speed, velocities.data());
    });
}

}  // namespace weft
#endif
