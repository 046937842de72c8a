#pragma once
// The data of a DrawnMesh.

#include <cstdint>
#include <vector>

#include "weft/drawn_mesh.h"

namespace weft {

/// The mesh of a cloth that bonds are for.
struct BoundMesh {
    std::uint32_t particles = 0, triangles = 0;
    std::uint64_t hash = 0;  ///< of the triangles

    BoundMesh() = default;
    explicit BoundMesh(const ClothView& cloth);
    friend bool operator==(const BoundMesh&, const BoundMesh&) = default;
};

struct WEFT_LOCAL DrawnMesh::Bonds {
    std::vector<DrawnBond> of_vertex;
    /// While a blend lasts: the bonds as they were bound, and as the blend began. Otherwise both are empty.
    std::vector<DrawnBond> own, start;

    [[nodiscard]] const std::vector<DrawnBond>& without_blend() const {
        return own.empty() ? of_vertex : own;
    }
    float rounding = 0;
    BoundMesh mesh;
};

}  // namespace weft
