#pragma once
// Cuts a scene's cloth, in the World and in the drawn content.

#include <span>
#include <vector>

#include "demo/scene.h"
#include "weft/cutting.h"

namespace weft::demo {

/// Positions of the mesh's own vertices [m].
[[nodiscard]] Result<std::vector<Vec3>> vertex_positions(const World& world, ClothId cloth);

/// Splits edges of the cloth's mesh, in the World as well. True: something was split. Errors: those of
/// cut_mesh() and World::recut_cloth(); a finer mesh is drawn over the cloth.
[[nodiscard]] Result<bool> cut_cloth(World& world, SceneCloth& cloth, std::span<const MeshEdge> edges);

/// Parameters of tearing.
struct Tearing {
    float strain = 0.2f;    ///< strain of an edge beyond which it tears
    std::size_t edges = 4;  ///< most edges torn in a step, the most strained first
};
/// Tears the cloth along edges that are strained more, but not at pins. True: something was split.
[[nodiscard]] Result<bool> tear_cloth(World& world, SceneCloth& cloth, const Tearing& tearing);

}  // namespace weft::demo
