#pragma once
// Kang's approximate implicit integration: a fixed number of block Jacobi iterations on W dv = b.

#include <span>

#include "cloth/cook.h"
#include "cloth/implicit/system.h"
#include "engine/parallel_blocks.h"

namespace weft {

/// Leaves the iterate in system.velocity_change. Returns |D^-1 (b - W dv)| / |D^-1 b| of the last iterate but
/// one, which is what the last iteration measures in passing; 1 for no iterations, 0 for b = 0. Precondition:
/// partials.size() >= block_count(particles).
float solve_jacobi(Parallel& parallel, const CookedCloth& model, int iterations, ImplicitSystem& system,
                   std::span<double> partials);

}  // namespace weft
