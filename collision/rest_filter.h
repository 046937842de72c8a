#pragma once
// Which close pairs are meant to be close.

#include <cstdint>
#include <span>

#include "weft/types.h"

namespace weft {

/// Per particle i: `neighbours[offsets[i] .. offsets[i + 1])` are its spring neighbours, and pairs closer
/// than the distance in `rest_positions` are left alone. Either may be empty.
struct RestFilter {
    std::span<const Vec4> rest_positions;
    std::span<const std::uint32_t> offsets;
    std::span<const std::uint32_t> neighbours;
};

}  // namespace weft
