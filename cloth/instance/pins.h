#pragma once
// A cloth's pins.

#include <cstdint>
#include <span>
#include <vector>

#include "cloth/state/state.h"

namespace weft {

/// The particles that are pinned, in the order of the pins.
[[nodiscard]] std::vector<std::uint32_t> particles_of(std::span<const Pin> pins);

}  // namespace weft
