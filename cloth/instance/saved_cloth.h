#pragma once
// Constant data of a cloth besides its model, as read from a file.

#include <memory>
#include <optional>

#include "cloth/air/surface.h"
#include "cloth/solver/levels/saved_levels.h"
#include "collision/contact/mesh/contact_mesh.h"
#include "collision/particles/rest_neighbours.h"

namespace weft {

/// Each member is of a cloth whose settings need it. Cloth's constructor makes those that are missing.
struct SavedCloth {
    Surface surface;
    std::optional<SavedLevels> levels;                ///< of the settings' system
    std::shared_ptr<const ContactMesh> contact_mesh;  ///< null: none
    std::optional<RestNeighbours> rest_neighbours;    ///< of the settings' method
};

}  // namespace weft
