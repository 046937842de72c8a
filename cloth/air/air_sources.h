#pragma once
// Local sources of moving air: jets, blasts, and wakes of balls that pass.

#include <algorithm>
#include <span>

#include "engine/threads/parallel_blocks.h"
#include "weft/settings.h"

namespace weft {

[[nodiscard]] inline bool has_sources(const Wind& wind) {
    return std::ranges::any_of(wind.sources,
                               [](const AirSource& source) { return source.kind != AirSourceKind::none; });
}

/// Adds the velocities that the sources make at points [m/s] to the air's. Both are in AlignedBuffers.
void add_air_of_sources(Parallel& parallel, const Wind& wind, std::span<const Vec4> points,
                        std::span<Vec4> velocities);

}  // namespace weft
