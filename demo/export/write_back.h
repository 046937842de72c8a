#pragma once
// From particles back to the vertices that are drawn or written.

#include <span>

#include "weft/world.h"

namespace weft::demo {

/// Each vertex gets its particle's position, but for pinned ones: these stay as the host has put them, which
/// is to the bit where its other meshes have their borders, so that no cracks open. `vertices`: one for each
/// of the cloth's mesh.
void write_back(const ClothView& cloth, std::span<Vec3> vertices);

}  // namespace weft::demo
