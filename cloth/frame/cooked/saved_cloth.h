#pragma once
// What is constant of a cloth beside its model, as it was read.

#include <optional>

#include "cloth/solvers/multigrid/saved_levels.h"
#include "cloth/surface/surface.h"

namespace weft {

struct SavedCloth {
    Surface surface;
    std::optional<SavedLevels> levels;  ///< of the settings' system; none: they are to be made
};

}  // namespace weft
