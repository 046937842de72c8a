#pragma once
// Mobility of a pair's gap, with bounds where pins leave its corners little leverage.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace weft {

/// Where a pair is nearest next to pins of both sides, as along a cut that ends at one, movable corners open
/// its gap by a small fraction of their own way, and would be flung off. No corner moves farther than this
/// multiple of what the gap lacks.
inline constexpr float farthest_for_gap = 2;
/// No corner moves at all if less than this fraction of its way opens the gap.
inline constexpr float least_of_way = 0.3f;

/// Gap over impulse [1/kg], by the corners' inverse masses and weights, within these bounds; 0: nothing opens
/// it.
[[nodiscard]] inline float mobility_of_gap(const std::array<float, 4>& inverse_masses,
                                           const std::array<float, 4>& weights) {
    float sum = 0, most = 0, part = 0;
    for (std::uint32_t i = 0; i < 4; ++i) {
        const float weight = std::abs(weights[i]), mobility = inverse_masses[i] * weight;
        sum += mobility * weight;
        most = std::max(most, mobility);
        if (mobility > 0) part = std::max(part, weight);
    }
    return part < least_of_way ? 0 : std::max(sum, most / farthest_for_gap);
}

}  // namespace weft
