#pragma once
// Normals of particles, for renderers.

#include <span>

#include "cloth/cook.h"
#include "cloth/state.h"
#include "engine/parallel_blocks.h"

namespace weft {

/// Means of the triangles' normals, weighted by area; +Y where they cancel out. `triangle_scratch`: one per
/// triangle.
void compute_normals(Parallel& parallel, const CookedCloth& model, std::span<Vec4> triangle_scratch,
                     ClothState& state);

}  // namespace weft
