#pragma once
// Springs as half-edges: the model stores each at both its ends.

#include <cstdint>
#include <vector>

#include "cloth/mesh/cook.h"

namespace weft {

/// By half-edge: the spring's other half-edge.
[[nodiscard]] inline std::vector<std::uint32_t> twin_half_edges(const ClothModel& model) {
    std::vector<std::uint32_t> twins(model.neighbours.size());
    for (std::uint32_t i = 0; i < model.particle_count; ++i)
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e)
            twins[e] = half_edge_between(model, model.neighbours[e], i);
    return twins;
}

}  // namespace weft
