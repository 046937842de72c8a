#pragma once
// Lines of the host's log about a mesh.

#include "weft/cooked_cloth.h"

namespace weft {

/// Logs what cooking repaired in a mesh, and what it could not.
void log_repairs(const ClothInfo& info) noexcept;

}  // namespace weft
