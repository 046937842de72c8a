#pragma once
// Walking over a cloth's springs, which the model stores at both their ends.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "cloth/mesh/cook.h"

namespace weft {

/// Of each half-edge, the spring's other one.
[[nodiscard]] inline std::vector<std::uint32_t> twin_half_edges(const CookedCloth& model) {
    std::vector<std::uint32_t> twins(model.neighbours.size());
    const std::uint32_t* const row = model.neighbours.data();
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
            const std::uint32_t j = row[e];
            twins[e] = static_cast<std::uint32_t>(
                std::lower_bound(row + model.spring_offsets[j], row + model.spring_offsets[j + 1], i) - row);
        }
    }
    return twins;
}

}  // namespace weft
