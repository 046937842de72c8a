#include "cloth/motion/survey.h"

#include <algorithm>
#include <limits>

#include "engine/vector.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/motion/survey.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "engine/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// Range of one coordinate, lane by lane.
struct Extent {
    Lanes lower, upper;

    HWY_INLINE void add(Lanes coordinate) {
        lower = hn::Min(lower, coordinate);
        upper = hn::Max(upper, coordinate);
    }
    [[nodiscard]] float least() const { return hn::GetLane(hn::MinOfLanes(Tag(), lower)); }
    [[nodiscard]] float greatest() const { return hn::GetLane(hn::MaxOfLanes(Tag(), upper)); }
};

struct SurveyLanes {
    Extent x, y, z;
    Lanes peak_speed_squared;
    hn::Mask<Tag> sound;

    HWY_INLINE void add(const Vec4* positions, const Vec4* velocities) {
        const Lanes4 position = load_rows(positions);
        const Lanes3 v = xyz(load_rows(velocities));
        const Lanes speed_squared = dot(v, v);
        x.add(position.x);
        y.add(position.y);
        z.add(position.z);
        peak_speed_squared = hn::Max(peak_speed_squared, speed_squared);
        // Comparisons are such that NaN fails them.
        const auto is_near = [](Lanes coordinate) {
            return hn::Le(hn::Abs(coordinate), hn::Set(Tag(), runaway_distance));
        };
        const auto is_finite = hn::Le(speed_squared, hn::Set(Tag(), std::numeric_limits<float>::max()));
        sound = hn::And(sound, hn::And(hn::And(is_near(position.x), is_near(position.y)),
                                       hn::And(is_near(position.z), is_finite)));
    }
};

Survey survey_block(const BlockRange& range, const Vec4* positions, const Vec4* velocities) {
    const Lanes infinity = hn::Set(Tag(), std::numeric_limits<float>::infinity()), zero = hn::Zero(Tag());
    const Extent nowhere = {infinity, hn::Neg(infinity)};
    SurveyLanes found = {nowhere, nowhere, nowhere, zero, hn::Eq(zero, zero)};
    std::uint32_t i = range.begin;
    for (; i + part_lanes <= range.end; i += part_lanes) found.add(positions + i, velocities + i);
    if (i < range.end) {  // padding of the last group: the last particle again
        alignas(64) Vec4 last_positions[part_lanes], last_velocities[part_lanes];
        for (std::uint32_t lane = 0; lane < part_lanes; ++lane) {
            const std::uint32_t from = std::min(i + lane, range.end - 1);
            last_positions[lane] = positions[from];
            last_velocities[lane] = velocities[from];
        }
        found.add(last_positions, last_velocities);
    }
    return {.lower = {found.x.least(), found.y.least(), found.z.least()},
            .upper = {found.x.greatest(), found.y.greatest(), found.z.greatest()},
            .peak_speed_squared = hn::GetLane(hn::MaxOfLanes(Tag(), found.peak_speed_squared)),
            .sound = hn::AllTrue(Tag(), found.sound)};
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // independent of the SIMD target
namespace weft {

HWY_EXPORT(survey_block);

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr Survey nothing{.lower = {infinity, infinity, infinity},
                         .upper = {-infinity, -infinity, -infinity},
                         .peak_speed_squared = 0,
                         .sound = true};

Survey combine(const Survey& l, const Survey& r) {
    return {.lower = {std::min(l.lower.x, r.lower.x), std::min(l.lower.y, r.lower.y),
                      std::min(l.lower.z, r.lower.z)},
            .upper = {std::max(l.upper.x, r.upper.x), std::max(l.upper.y, r.upper.y),
                      std::max(l.upper.z, r.upper.z)},
            .peak_speed_squared = std::max(l.peak_speed_squared, r.peak_speed_squared),
            .sound = l.sound && r.sound};
}

}  // namespace

Survey survey(Parallel& parallel, const ClothState& state, std::span<Survey> partials) {
    return parallel.reduce(
        state.size(), partials, nothing,
        [&](const BlockRange& range) {
            return HWY_DYNAMIC_DISPATCH(survey_block)(range, state.positions.data(), state.velocities.data());
        },
        combine);
}

}  // namespace weft
#endif
