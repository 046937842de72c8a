#pragma once
// Fans, blasts and balls that pass: air that moves at one place.

#include <algorithm>
#include <span>

#include "engine/threads/parallel_blocks.h"
#include "weft/settings.h"

namespace weft {

[[nodiscard]] inline bool has_sources(const Wind& wind) {
    return std::ranges::any_of(wind.sources,
                               [](const AirSource& source) { return source.kind != AirSourceKind::none; });
}

/// Adds to the air's velocities at points [m/s] what the sources make; both in AlignedBuffers.
void add_air_of_sources(Parallel& parallel, const Wind& wind, std::span<const Vec4> points,
                        std::span<Vec4> velocities);

}  // namespace weft
