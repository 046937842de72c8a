#pragma once
// The state of a cloth, carried by its surface to the vertices of another mesh of the garment.

#include <vector>

#include "engine/vector.h"
#include "weft/drawn_mesh.h"

namespace weft {

/// The rows of a bond's three particles, interpolated at its point of the surface.
template <class Rows>
[[nodiscard]] Vector3 interpolated(const DrawnBond& bond, const Rows& rows) {
    const auto at = [&](std::size_t c) { return xyz(rows[bond.particles[c]]); };
    return (1 - bond.second - bond.third) * at(0) + bond.second * at(1) + bond.third * at(2);
}

/// State at the vertices that bonds are of. Vectors that have the room allocate nothing.
struct SurfaceState {
    std::vector<Vec4> drawn;  ///< room for what bonds write
    std::vector<Vec3> positions, previous_positions, velocities;

    void reserve(std::size_t vertices);
    /// Precondition: the bonds are to the cloth of this view.
    void carry(const ClothView& from, const DrawnMesh& bonds);
};

}  // namespace weft
