#pragma once
// Scenes' cloth that is cut: in the World, and in what draws it.

#include <span>
#include <vector>

#include "demo/scene.h"
#include "weft/cutting.h"

namespace weft::demo {

/// Where the mesh's own vertices are [m].
[[nodiscard]] Result<std::vector<Vec3>> vertex_positions(const World& world, ClothId cloth);

/// Parts edges of the cloth's mesh, in the World as well. True: something parted. Errors: as cut_mesh() and
/// World::recut_cloth(); cloth that a finer mesh is drawn over.
[[nodiscard]] Result<bool> cut_cloth(World& world, SceneCloth& cloth, std::span<const MeshEdge> edges);

/// What cloth tears by.
struct Tearing {
    float strain = 0.2f;    ///< of an edge, beyond which it gives way
    std::size_t edges = 4;  ///< in a step at most, those that are strained most
};
/// Tears where it is strained more, but not at pins. True: something parted.
[[nodiscard]] Result<bool> tear_cloth(World& world, SceneCloth& cloth, const Tearing& tearing);

}  // namespace weft::demo
