#pragma once
// What is constant of a cloth beside its model, as it was read.

#include <memory>
#include <optional>

#include "cloth/air/surface.h"
#include "cloth/solver/levels/saved_levels.h"
#include "collision/contact/pairs/contact_mesh.h"
#include "collision/particles/rest_neighbours.h"

namespace weft {

/// Each of a cloth whose settings ask for it. What is missing is made, by whoever takes these.
struct SavedCloth {
    Surface surface;
    std::optional<SavedLevels> levels;                ///< of the settings' system
    std::shared_ptr<const ContactMesh> contact_mesh;  ///< null: none
    std::optional<RestNeighbours> rest_neighbours;    ///< of the settings' method
};

}  // namespace weft
