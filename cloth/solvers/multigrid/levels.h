#pragma once
// The levels of a cloth's multigrid as a function of its mesh and of one setting: the same settings give the
// same levels, whatever was set before.

#include <memory>

#include "cloth/mesh/cook.h"
#include "cloth/solvers/multigrid/multigrid.h"
#include "cloth/system/implicit_system.h"
#include "weft/settings.h"

namespace weft {

/// All that levels depend on besides the mesh. Stiffnesses beyond this only scale the springs that levels
/// interpolate along; their ratios hardly matter to how fast cycles converge.
struct LevelsKey {
    bool elements = false;  ///< finite elements, not springs

    friend bool operator==(const LevelsKey&, const LevelsKey&) = default;
};
[[nodiscard]] LevelsKey levels_key(const ClothSettings& settings);

/// Levels with no pins, from the cloth where it starts and a fabric that stands for all of the key.
/// `system` is of the key's kind, and is left linearised about that.
[[nodiscard]] std::unique_ptr<Multigrid> make_levels(const CookedCloth& model, const LevelsKey& key,
                                                     ImplicitSystem& system);

}  // namespace weft
