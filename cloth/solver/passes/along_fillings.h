#pragma once
// The filling of a member, in the passes over its group.

#include "cloth/solver/passes/passes.h"

namespace weft {

/// Linearises the filling at the member's velocities; before its system, which takes the pressure.
void linearise_filling(const PassMember& member, Parallel& threads);
/// Finds how the cloth of one member gives way to pressure; after its levels are built, which others may have
/// in common with it. Takes from the member's motion, relative to `frame`, and from its last change, if it
/// has one, what the filling resists.
void find_response(std::span<const PassMember> members, const PassMember& member, const Vec4& frame,
                   bool has_change);
/// Takes from a direction what the filling resists.
void relieve(const PassMember& member, Parallel& threads, std::span<Vec4> direction);
/// Adds the filling's term to the product, unless it is empty. Returns x . C x, with C the filling's matrix.
double multiply_filling(const PassMember& member, Parallel& threads, std::span<const Vec4> x,
                        std::span<Vec4> product);
/// After velocities have changed: linearises the filling anew. One that keeps its volume first changes the
/// velocities, and the present pass's motion and change, along the response until it has that volume.
void follow_filling(const PassMember& member, Parallel& threads);

}  // namespace weft
