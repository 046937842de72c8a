#pragma once
// The state of a cloth, carried by its surface to the vertices of another mesh of the garment.

#include <vector>

#include "weft/drawn_mesh.h"

namespace weft {

/// State at the vertices that bonds are of. Vectors that have the room allocate nothing.
struct SurfaceState {
    std::vector<Vec4> drawn;  ///< room for what bonds write
    std::vector<Vec3> positions, previous_positions, velocities;

    void reserve(std::size_t vertices);
    /// Precondition: the bonds are to the cloth of this view.
    void carry(const ClothView& from, const DrawnMesh& bonds);
};

}  // namespace weft
