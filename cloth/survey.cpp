#include "cloth/survey.h"

#include <algorithm>
#include <limits>

#include "engine/vector.h"

namespace weft {

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
            Survey found = nothing;
            for (std::uint32_t i = range.begin; i < range.end; ++i) {
                const Vec4& x = state.positions[i];
                const float speed_squared = xyz(state.velocities[i]).squaredNorm();
                const float farthest = std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)});
                // Written so that a comparison with not-a-number fails. max() may pass one over: the sum does
                // not.
                const bool sound = farthest <= runaway_distance &&
                                   speed_squared <= runaway_speed * runaway_speed &&
                                   std::abs(x.x + x.y + x.z) <= 3 * runaway_distance;
                found = combine(found, {.lower = {x.x, x.y, x.z},
                                        .upper = {x.x, x.y, x.z},
                                        .peak_speed_squared = speed_squared,
                                        .sound = sound});
            }
            return found;
        },
        combine);
}

}  // namespace weft
