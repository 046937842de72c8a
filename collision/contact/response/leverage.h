#pragma once
// How easily the corners of a pair open its gap, where pins leave them little to do it with.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace weft {

/// Where a pair is nearest next to pins of both sides, as along a cut that ends at one, what can move opens
/// it by a small part of its own way, and would be flung off. So no corner is to go farther than so many
/// times what the gap lacks,
inline constexpr float farthest_for_gap = 2;
/// and none at all where less than this part of its way gets there.
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
