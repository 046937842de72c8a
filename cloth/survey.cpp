#include "cloth/survey.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/vector.h"

namespace weft {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr Survey nothing{.lower = {infinity, infinity, infinity},
                         .upper = {-infinity, -infinity, -infinity},
                         .peak_speed_squared = 0,
                         .sound = true};

/// Written so that not-a-number fails.
bool is_near(float coordinate) {
    return std::abs(coordinate) <= runaway_distance;
}

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
                const bool sound =
                    is_near(x.x) && is_near(x.y) && is_near(x.z) && std::isfinite(speed_squared);
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
