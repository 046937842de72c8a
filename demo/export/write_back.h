#pragma once
// Copies particles back to the vertices that are drawn or written.

#include <span>

#include "weft/world.h"

namespace weft::demo {

/// Gives each vertex its particle's position, except pinned ones. These keep the host's positions, which
/// match the borders of its other meshes to the bit, so that no cracks open. `vertices`: one for each of the
/// cloth's mesh.
void write_back(const ClothView& cloth, std::span<Vec3> vertices);

}  // namespace weft::demo
