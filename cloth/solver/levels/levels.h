#pragma once
// The levels of a cloth's multigrid as a function of its mesh and of the kind of its system: whatever was set
// before, the same cloth has the same levels. Stiffnesses only scale the springs that levels interpolate
// along; their ratios hardly matter to how fast cycles converge.

#include <memory>

#include "cloth/equation/implicit_system.h"
#include "cloth/mesh/cook.h"
#include "cloth/solver/levels/multigrid.h"
#include "cloth/solver/levels/saved_levels.h"

namespace weft {

/// Levels with no pins, from the cloth where it starts and the default fabric. `system` is left linearised
/// about that. `saved` levels are taken in their place, unless they do not fit the elements' system.
[[nodiscard]] std::unique_ptr<Multigrid> make_levels(const ClothModel& model, ImplicitSystem& system,
                                                     SavedLevels* saved = nullptr);

}  // namespace weft
