#pragma once
// The levels of a cloth's multigrid depend on its mesh and the kind of its system only, not on earlier
// settings. Stiffnesses only scale the springs that levels interpolate along; their ratios hardly affect how
// fast cycles converge.

#include <memory>

#include "cloth/equation/implicit_system.h"
#include "cloth/mesh/cook.h"
#include "cloth/solver/levels/multigrid.h"
#include "cloth/solver/levels/saved_levels.h"

namespace weft {

/// Makes levels without pins, from the cloth's first positions and the default fabric, and leaves `system`
/// linearised about these. Returns the `saved` levels instead if they fit the system.
[[nodiscard]] std::unique_ptr<Multigrid> make_levels(const ClothModel& model, ImplicitSystem& system,
                                                     SavedLevels* saved = nullptr);

/// Linearises a cloth's system about its first positions, with the default fabric, and returns these.
[[nodiscard]] AlignedBuffer<Vec4> linearise_at_rest(const ClothModel& model, ImplicitSystem& system);

}  // namespace weft
