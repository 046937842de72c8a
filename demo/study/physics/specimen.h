#pragma once
// Pieces of cloth to be tested, as sheets and as meshes of triangles, and their settings.

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "weft/weft.h"

namespace weft::study {

/// The model of the fabric's stiffness, and its mesh.
enum class ForceModel {
    sheet,     ///< springs along a sheet's threads
    mesh,      ///< springs along the edges of a general mesh
    elements,  ///< finite elements on that mesh
};
inline constexpr std::array force_models{ForceModel::sheet, ForceModel::mesh, ForceModel::elements};
[[nodiscard]] const char* name_of(ForceModel model);

/// Settings without air damping, with the default method. Tests change what they need.
[[nodiscard]] ClothSettings made_of(ForceModel model, const Fabric& fabric);

/// Maps a point of the pattern to space.
using Place = std::function<Vec3(Vec2)>;

/// A rectangle [0, length] x [0, width] of the pattern, warp along the length, in `cells` columns along it:
/// as a sheet of nearly square cells, or of nearly equilateral triangles with straight columns. The pattern
/// is its rest shape.
struct Strip {
    double length = 1, width = 1;
    std::uint32_t cells = 16;
};
[[nodiscard]] Mesh strip_mesh(ForceModel model, const Strip& strip, const Place& place);

/// A pseudo-random value from -1 to 1, always the same for the same `number`.
[[nodiscard]] float noise(std::uint32_t number);

}  // namespace weft::study
