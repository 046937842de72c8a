#pragma once
// The seams among the members of a group, in the passes over it.

#include <span>

#include "cloth/solver/passes/passes.h"

namespace weft {

/// Linearises the seams at the members' velocities.
void linearise_seams(std::span<const PassMember> members);
/// Adds the seams' terms to the product, unless it is null. Returns x . C x, with C the seams' matrix.
double multiply_seams(std::span<const PassMember> members, ScratchArray<Vec4> PassVectors::*x,
                      ScratchArray<Vec4> PassVectors::*product);
/// Whether a stitch ends at a particle that is not free.
[[nodiscard]] bool join_what_is_held(std::span<const PassMember> members);

}  // namespace weft
