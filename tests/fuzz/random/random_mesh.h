#pragma once
// Meshes of all kinds: sheets, general meshes, several components, patterns with seams, and broken ones.

#include "tests/fuzz/random/random.h"

namespace weft::fuzz {

/// At most some 1700 vertices, within a few metres of the origin.
[[nodiscard]] Drawn<Mesh> random_mesh(Random& random);

}  // namespace weft::fuzz
