#pragma once
// What the host's log is told of a mesh.

#include "weft/cooked_cloth.h"

namespace weft {

/// Tells the log what cooking left out, turned and found.
void log_repairs(const ClothInfo& info) noexcept;

}  // namespace weft
